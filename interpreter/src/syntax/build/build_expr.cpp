// Builds expressions.

#include <limits>

#include "ast/marks.hpp"
#include "syntax/build/build_ast.hpp"

namespace armlet::lang {
namespace {

using antlr4::tree::ParseTree;
using antlr4::tree::TerminalNode;

ast::Expr base(ast::ExprKind kind, Span span) { return {.kind = kind, .span = span}; }

RbtParser::ExprContext* left_operand(RbtParser::ExprContext* ctx) {
  return dynamic_cast<RbtParser::ExprContext*>(ctx->children.front());
}

}  // namespace

ast::Expr* AstBuilder::expression(RbtParser::ExpressionContext* ctx) {
  const Deeper deeper(*this, 1, span_of(ctx));
  ParseTree* first = ctx->children.front();
  if (ctx->start->getType() == RbtParser::FN)
    return lambda(static_cast<RbtParser::LambdaContext*>(first));
  if (ctx->start->getType() == RbtParser::NEW) {
    if (auto* made = dynamic_cast<RbtParser::NewArrayContext*>(first)) return new_array(made);
  }
  ast::Expr* value = expr(static_cast<RbtParser::ExprContext*>(first));
  if (ctx->children.size() == 1) return value;
  const Span until = token_span(ctx->UNTIL()->getSymbol());
  if (value->kind != ast::ExprKind::kCall) {
    Diagnostic out = make_diagnostic("E0128", until, {"until"});
    out.why = "`until` ends a motion early, so a motion stands before it";
    out.fix = Fix{"write wait until ... to wait for a condition", {}, Confidence::kMaybe};
    report(std::move(out));
  }
  return in_.arena.make<ast::UntilExpr>(base(ast::ExprKind::kUntil, span_of(ctx)), value,
                                        expr(ctx->expr(1)));
}

// A chain of operators and suffixes becomes a tree that grows to the left. A loop builds it, so
// that long chains need no recursion.
ast::Expr* AstBuilder::expr(RbtParser::ExprContext* ctx) {
  std::vector<RbtParser::ExprContext*> spine;
  while (RbtParser::ExprContext* left = left_operand(ctx)) {
    spine.push_back(ctx);
    ctx = left;
  }
  const Deeper deeper(*this, spine.size() + 1, span_of(spine.empty() ? ctx : spine.front()));
  ast::Expr* value = leaf(ctx);
  for (auto at = spine.rbegin(); at != spine.rend(); ++at) value = extend(value, *at);
  return value;
}

ast::Expr* AstBuilder::leaf(RbtParser::ExprContext* ctx) {
  if (auto* plain = dynamic_cast<RbtParser::PrimaryEContext*>(ctx))
    return primary(plain->primary());
  if (auto* sign = dynamic_cast<RbtParser::UnaryEContext*>(ctx)) return unary(sign);
  auto* cast = static_cast<RbtParser::CastEContext*>(ctx);
  const Span type = span_of(cast->primType());
  return in_.arena.make<ast::CastExpr>(base(ast::ExprKind::kCast, span_of(ctx)),
                                       ast::Name{text(type), type}, expr(cast->expr()));
}

ast::Expr* AstBuilder::unary(RbtParser::UnaryEContext* ctx) {
  const Span span = span_of(ctx);
  const std::size_t sign = ctx->start->getType();
  // The smallest int: its digits without the sign would be too large.
  if (sign == RbtParser::MINUS && text(span_of(ctx->expr())) == "9223372036854775808") {
    return in_.arena.make<ast::IntExpr>(base(ast::ExprKind::kInt, span),
                                        std::numeric_limits<std::int64_t>::min(), false);
  }
  const ast::UnaryOp op = sign == RbtParser::MINUS  ? ast::UnaryOp::kMinus
                          : sign == RbtParser::PLUS ? ast::UnaryOp::kPlus
                                                    : ast::UnaryOp::kNot;
  return in_.arena.make<ast::UnaryExpr>(base(ast::ExprKind::kUnary, span), op, expr(ctx->expr()));
}

// `ctx` is `left` with one more operator or suffix.
ast::Expr* AstBuilder::extend(ast::Expr* left, RbtParser::ExprContext* ctx) {
  const Span span = span_of(ctx);
  auto* mark = dynamic_cast<TerminalNode*>(ctx->children[1]);
  if (mark == nullptr) {
    auto* list = static_cast<RbtParser::ArgsContext*>(ctx->children[1]);
    return in_.arena.make<ast::CallExpr>(base(ast::ExprKind::kCall, span), left, args(list),
                                         span_of(list));
  }
  const antlr4::Token* op = mark->getSymbol();
  if (op->getType() == RbtParser::DOT) {
    auto* member = static_cast<RbtParser::NameContext*>(ctx->children[2]);
    return in_.arena.make<ast::MemberExpr>(base(ast::ExprKind::kMember, span), left, name(member));
  }
  if (op->getType() == RbtParser::LBRACK) return index(left, ctx);
  ast::Expr* right = expr(static_cast<RbtParser::ExprContext*>(ctx->children[2]));
  if (op->getType() == RbtParser::QMARK) {
    ast::Expr* no = expr(static_cast<RbtParser::ExprContext*>(ctx->children[4]));
    return in_.arena.make<ast::CondExpr>(base(ast::ExprKind::kCond, span), left, right, no);
  }
  return in_.arena.make<ast::BinaryExpr>(base(ast::ExprKind::kBinary, span),
                                         *mark_of(op->getType()).operation, left, right,
                                         token_span(op));
}

ast::Expr* AstBuilder::index(ast::Expr* object, RbtParser::ExprContext* ctx) {
  std::vector<ast::IndexItem> items;
  for (ParseTree* node : ctx->children) {
    if (auto* item = dynamic_cast<RbtParser::IndexItemContext*>(node))
      items.push_back(index_item(item));
  }
  return in_.arena.make<ast::IndexExpr>(base(ast::ExprKind::kIndex, span_of(ctx)), object,
                                        in_.arena.copy(items));
}

ast::IndexItem AstBuilder::index_item(RbtParser::IndexItemContext* ctx) {
  ast::IndexItem out{};
  out.span = span_of(ctx);
  for (ParseTree* node : ctx->children) {
    if (auto* value = dynamic_cast<RbtParser::ExpressionContext*>(node)) {
      (out.is_range ? out.last : out.first) = expression(value);
    } else {
      out.is_range = true;
    }
  }
  return out;
}

ast::Expr* AstBuilder::primary(RbtParser::PrimaryContext* ctx) {
  const Span span = span_of(ctx);
  switch (ctx->start->getType()) {
    case RbtParser::LPAREN: {
      ast::Expr* inner = expression(ctx->expression());
      if (inner->parens < std::numeric_limits<std::uint8_t>::max()) ++inner->parens;
      return inner;
    }
    case RbtParser::LBRACK:
      return list_or_matrix(ctx);
    case RbtParser::NEW:
      return in_.arena.make<ast::NewObjectExpr>(base(ast::ExprKind::kNewObject, span),
                                                named_type(ctx->typeName()), args(ctx->args()));
    case RbtParser::ID:
    case RbtParser::TEST:
    case RbtParser::RECORD:
    case RbtParser::PATH:
    case RbtParser::AS:
      return in_.arena.make<ast::NameExpr>(base(ast::ExprKind::kName, span), text(span));
    case RbtParser::INT_T:
    case RbtParser::DOUBLE_T:
    case RbtParser::BOOL_T: {
      const Span type = token_span(ctx->start);
      auto* callee = in_.arena.make<ast::NameExpr>(base(ast::ExprKind::kName, type), text(type));
      return in_.arena.make<ast::CallExpr>(base(ast::ExprKind::kCall, span), callee,
                                           args(ctx->args()), span_of(ctx->args()));
    }
  }
  return literal(static_cast<RbtParser::LiteralContext*>(ctx->children.front()));
}

ast::Expr* AstBuilder::lambda(RbtParser::LambdaContext* ctx) {
  auto* out = fresh<ast::LambdaExpr>(ast::ExprKind::kLambda, span_of(ctx));
  out->params = params(ctx->params());
  out->result = result_type(ctx->resultType());
  if (ctx->block() != nullptr) {
    out->body = function_block(ctx->block());
  } else {
    out->value = expression(ctx->expression());
  }
  return out;
}

ast::Expr* AstBuilder::new_array(RbtParser::NewArrayContext* ctx) {
  const Deeper deeper(*this, ctx->newDim().size() + ctx->LBRACK().size(), span_of(ctx));
  auto* out = fresh<ast::NewArrayExpr>(ast::ExprKind::kNewArray, span_of(ctx));
  out->element = base_type(ctx->primType(), ctx->typeName());
  std::vector<ast::Expr*> sizes;
  for (RbtParser::NewDimContext* dimension : ctx->newDim())
    sizes.push_back(expression(dimension->expression()));
  out->sizes = in_.arena.copy(sizes);
  out->open_dimensions = static_cast<int>(ctx->LBRACK().size());
  if (ctx->braceInit() != nullptr) out->init = brace_init(ctx->braceInit());
  return out;
}

ast::Expr* AstBuilder::initializer(RbtParser::InitializerContext* ctx) {
  return ctx->braceInit() != nullptr ? brace_init(ctx->braceInit()) : expression(ctx->expression());
}

// All expressions directly below `ctx`.
ast::Seq<ast::Expr*> AstBuilder::expressions(const antlr4::ParserRuleContext* ctx) {
  std::vector<ast::Expr*> out;
  for (ParseTree* node : ctx->children) {
    if (auto* value = dynamic_cast<RbtParser::ExpressionContext*>(node))
      out.push_back(expression(value));
  }
  return in_.arena.copy(out);
}

ast::Seq<ast::Arg> AstBuilder::args(RbtParser::ArgsContext* ctx) {
  if (ctx == nullptr || ctx->children.size() == 2) return {};
  return args(ctx->arg());
}

ast::Seq<ast::Arg> AstBuilder::args(const std::vector<RbtParser::ArgContext*>& list) {
  std::vector<ast::Arg> out;
  out.reserve(list.size());
  for (RbtParser::ArgContext* ctx : list) {
    ast::Arg arg{};
    arg.span = span_of(ctx);
    if (ctx->children.size() > 1)
      arg.name = name(static_cast<RbtParser::NameContext*>(ctx->children.front()));
    arg.value = expression(static_cast<RbtParser::ExpressionContext*>(ctx->children.back()));
    if (arg.name.text.empty() && !out.empty() && !out.back().name.text.empty()) {
      Diagnostic message = make_diagnostic("E0326", arg.span);
      message.related.push_back({out.back().span, "a named value"});
      report(std::move(message));
    }
    out.push_back(arg);
  }
  return in_.arena.copy(out);
}

}  // namespace armlet::lang
