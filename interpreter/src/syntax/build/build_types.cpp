// Builds types and parameters, and has functions for all parts of the builder.

#include "base/cancelled.hpp"
#include "syntax/build/build_ast.hpp"

namespace armlet::lang {

AstBuilder::Deeper::Deeper(AstBuilder& builder, std::size_t levels, Span span)
    : builder_(builder), levels_(levels) {
  stop_if(builder_.in_.cancelled);
  if (builder_.depth_ + levels_ > builder_.in_.max_depth) throw TreeTooDeep{span};
  builder_.depth_ += levels_;
}

Span AstBuilder::token_span(const antlr4::Token* token) const {
  const Token& found = in_.tokens[token->getTokenIndex()];
  return {found.begin, found.end, in_.source.id()};
}

Span AstBuilder::span_of(const antlr4::ParserRuleContext* ctx) const {
  const std::size_t first = ctx->start->getTokenIndex();
  std::size_t last = ctx->stop->getTokenIndex();
  if (last > first && in_.tokens[last].type == RbtParser::SEMI) --last;
  return {in_.tokens[first].begin, in_.tokens[last].end, in_.source.id()};
}

ast::Name AstBuilder::name(RbtParser::NameContext* ctx) const {
  const Span span = token_span(ctx->start);
  return {text(span), span};
}

void AstBuilder::report(Diagnostic diagnostic) {
  failed_ = failed_ || diagnostic.severity == Severity::kError;
  in_.sink.report(std::move(diagnostic));
}

ast::TypeExpr* AstBuilder::type_expr(ast::TypeForm form, Span span) {
  auto* out = in_.arena.make<ast::TypeExpr>();
  out->form = form;
  out->span = span;
  return out;
}

ast::TypeExpr* AstBuilder::any_type(RbtParser::AnyTypeContext* ctx) {
  return ctx->fnType() != nullptr ? function_type(ctx->fnType()) : dim_type(ctx->dimType());
}

ast::TypeExpr* AstBuilder::dim_type(RbtParser::DimTypeContext* ctx) {
  std::vector<ast::TypeFactor> factors;
  int sign = 1;
  for (antlr4::tree::ParseTree* node : ctx->children) {
    if (auto* mark = dynamic_cast<antlr4::tree::TerminalNode*>(node)) {
      sign = mark->getSymbol()->getType() == RbtParser::SLASH ? -1 : 1;
      continue;
    }
    auto* factor = static_cast<RbtParser::DimFactorContext*>(node);
    int exponent = sign;
    if (antlr4::tree::TerminalNode* number = factor->INT()) {
      const std::string_view digits = text(token_span(number->getSymbol()));
      // No dimension has an exponent of two digits; the checker rejects larger ones.
      exponent *= digits.size() > 2 ? 99 : std::stoi(std::string(digits));
      if (factor->MINUS() != nullptr) exponent = -exponent;
    }
    factors.push_back(
        {factor->inParens() != nullptr ? type_in_parens(factor) : type(factor->type()), exponent});
  }
  if (factors.size() == 1 && factors.front().exponent == 1) return factors.front().type;
  ast::TypeExpr* out = type_expr(ast::TypeForm::kProduct, span_of(ctx));
  out->factors = in_.arena.copy(factors);
  return out;
}

// A type in parentheses, such as (fn(int) -> int)[].
ast::TypeExpr* AstBuilder::type_in_parens(RbtParser::DimFactorContext* ctx) {
  const Deeper deeper(*this, 1, span_of(ctx));
  return in_brackets(any_type(ctx->inParens()->anyType()), ctx->bracketPair(), span_of(ctx));
}

ast::TypeExpr* AstBuilder::function_type(RbtParser::FnTypeContext* ctx) {
  const Deeper deeper(*this, 1, span_of(ctx));
  std::vector<ast::TypeExpr*> parameters;
  for (RbtParser::AnyTypeContext* parameter : ctx->anyType())
    parameters.push_back(any_type(parameter));
  ast::TypeExpr* out = type_expr(ast::TypeForm::kFunction, span_of(ctx));
  out->parameters = in_.arena.copy(parameters);
  out->result = result_type(ctx->resultType());
  return out;
}

ast::TypeExpr* AstBuilder::result_type(RbtParser::ResultTypeContext* ctx) {
  if (ctx == nullptr) return nullptr;
  return ctx->anyType() != nullptr ? any_type(ctx->anyType())
                                   : type_expr(ast::TypeForm::kVoid, span_of(ctx));
}

ast::TypeExpr* AstBuilder::type(RbtParser::TypeContext* ctx) {
  return in_brackets(base_type(ctx->primType(), ctx->typeName()), ctx->bracketPair(), span_of(ctx));
}

ast::TypeExpr* AstBuilder::base_type(RbtParser::PrimTypeContext* primitive,
                                     RbtParser::TypeNameContext* named) {
  if (primitive == nullptr) return named_type(named);
  const Span span = span_of(primitive);
  const std::vector<ast::Name> path = {{text(span), span}};
  ast::TypeExpr* out = type_expr(ast::TypeForm::kPrimitive, span);
  out->path = in_.arena.copy(path);
  return out;
}

ast::TypeExpr* AstBuilder::named_type(RbtParser::TypeNameContext* ctx) {
  std::vector<ast::Name> path;
  for (RbtParser::NameContext* part : ctx->name()) path.push_back(name(part));
  ast::TypeExpr* out = type_expr(ast::TypeForm::kNamed, span_of(ctx));
  out->path = in_.arena.copy(path);
  return out;
}

ast::TypeExpr* AstBuilder::array_of(ast::TypeExpr* element, std::size_t dimensions, Span span) {
  const Deeper deeper(*this, dimensions, span);
  for (std::size_t i = 0; i < dimensions; ++i) {
    ast::TypeExpr* array = type_expr(ast::TypeForm::kArray, span);
    array->element = element;
    element = array;
  }
  return element;
}

// int[string][]: from left to right, each pair of brackets makes a list or a map of the type before
// it.
ast::TypeExpr* AstBuilder::in_brackets(ast::TypeExpr* element,
                                       const std::vector<RbtParser::BracketPairContext*>& pairs,
                                       Span span) {
  const Deeper deeper(*this, pairs.size(), span);
  for (RbtParser::BracketPairContext* pair : pairs) {
    const bool is_map = pair->children.size() > 2;
    ast::TypeExpr* type = type_expr(is_map ? ast::TypeForm::kMap : ast::TypeForm::kArray, span);
    type->element = element;
    if (is_map) type->key = base_type(pair->primType(), pair->typeName());
    element = type;
  }
  return element;
}

ast::Seq<ast::Param> AstBuilder::params(RbtParser::ParamsContext* ctx) {
  std::vector<ast::Param> list;
  if (ctx == nullptr) return {};
  for (RbtParser::ParamContext* one : ctx->param()) list.push_back(param(one));
  return in_.arena.copy(list);
}

ast::Param AstBuilder::param(RbtParser::ParamContext* ctx) {
  ast::Param out{};
  out.name = name(ctx->name());
  out.span = span_of(ctx);
  if (ctx->type() != nullptr) {
    out.type = array_of(type(ctx->type()), ctx->LBRACK().size(), out.span);
  } else if (ctx->anyType() != nullptr) {
    out.type = any_type(ctx->anyType());
  }
  if (ctx->expression() != nullptr) out.default_value = expression(ctx->expression());
  return out;
}

}  // namespace armlet::lang
