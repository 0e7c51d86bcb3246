// Builds declarations.

#include <algorithm>

#include "syntax/build/build_ast.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kDocMark = "///";

}  // namespace

// Declarations that are allowed at the top level of a file only.
ast::Stmt* AstBuilder::top_declaration(RbtParser::StmtContext* ctx) {
  const char* what = ctx->fnDecl() != nullptr       ? "a function"
                     : ctx->structDecl() != nullptr ? "a struct"
                     : ctx->enumDecl() != nullptr   ? "an enum"
                     : ctx->importDecl() != nullptr ? "an import"
                                                    : "a test";
  if (!place_.at_top) {
    Diagnostic out = make_diagnostic("E0132", token_span(ctx->start), {what});
    if (ctx->fnDecl() != nullptr) {
      out.fix = Fix{"write let name = fn(...) { ... } for a function inside a block", {}, {}};
      if (ctx->start->getType() == RbtParser::FN) {
        const Span name = span_of(ctx->fnDecl()->name());
        out.fix->edits.push_back({{token_span(ctx->start).begin, name.end, name.source},
                                  "let " + std::string(in_.source.slice(name)) + " = fn"});
      }
    }
    report(std::move(out));
  }
  if (ctx->fnDecl() != nullptr) return fn_decl(ctx->fnDecl());
  if (ctx->structDecl() != nullptr) return struct_decl(ctx->structDecl());
  if (ctx->enumDecl() != nullptr) return enum_decl(ctx->enumDecl());
  if (ctx->importDecl() != nullptr) return import_decl(ctx->importDecl());
  return test_decl(ctx->testDecl());
}

ast::Stmt* AstBuilder::let_decl(RbtParser::LetDeclContext* ctx) {
  auto* out = fresh<ast::VarStmt>(ast::StmtKind::kVar, span_of(ctx));
  out->fixed = ctx->LET() != nullptr;
  out->keyword = token_span(ctx->start);
  out->doc = doc(ctx);
  ast::Declarator made{};
  made.name = name(ctx->name());
  if (ctx->anyType() != nullptr) made.type = any_type(ctx->anyType());
  if (ctx->initializer() != nullptr) made.init = initializer(ctx->initializer());
  const std::vector<ast::Declarator> one = {made};
  out->declarators = in_.arena.copy(one);
  return out;
}

ast::Stmt* AstBuilder::var_decl(RbtParser::VarDeclContext* ctx) {
  auto* out = fresh<ast::VarStmt>(ast::StmtKind::kVar, span_of(ctx));
  out->fixed = ctx->FINAL() != nullptr;
  out->classic = true;
  out->keyword = out->fixed ? token_span(ctx->start) : span_of(ctx->type());
  out->doc = doc(ctx);
  ast::TypeExpr* shared = type(ctx->type());
  std::vector<ast::Declarator> list;
  for (RbtParser::DeclaratorContext* one : ctx->declarator()) {
    ast::Declarator made{};
    made.name = name(one->name());
    made.type = array_of(shared, one->LBRACK().size(), cover(shared->span, made.name.span));
    if (one->initializer() != nullptr) made.init = initializer(one->initializer());
    list.push_back(made);
  }
  out->declarators = in_.arena.copy(list);
  return out;
}

ast::Stmt* AstBuilder::block_decl(RbtParser::BlockDeclContext* ctx) {
  auto* out = fresh<ast::ObjectStmt>(ast::StmtKind::kObject, span_of(ctx));
  out->type = named_type(ctx->typeName());
  out->name = name(ctx->name());
  out->items = block_items(ctx->blockItem());
  out->doc = doc(ctx);
  return out;
}

ast::Seq<ast::BlockItem> AstBuilder::block_items(
    const std::vector<RbtParser::BlockItemContext*>& list) {
  std::vector<ast::BlockItem> items;
  for (RbtParser::BlockItemContext* ctx : list) {
    if (ctx->name().empty()) continue;  // a `;` alone
    ast::BlockItem item{};
    item.name = name(ctx->name(0));
    item.span = span_of(ctx);
    if (ctx->expression() != nullptr) {
      item.value = expression(ctx->expression());
      item.span = cover(item.name.span, span_of(ctx->expression()));
    } else {
      item.is_row = true;
      item.constructor = name(ctx->name(1));
      item.args = args(ctx->args());
    }
    items.push_back(item);
  }
  return in_.arena.copy(items);
}

ast::Stmt* AstBuilder::fn_decl(RbtParser::FnDeclContext* ctx) {
  auto* out = fresh<ast::FunctionStmt>(ast::StmtKind::kFunction, span_of(ctx));
  out->name = name(ctx->name());
  out->params = params(ctx->params());
  out->classic = ctx->FN() == nullptr;
  out->doc = doc(ctx);
  if (!out->classic) {
    out->result = result_type(ctx->resultType());
  } else if (ctx->VOID() != nullptr) {
    out->result = type_expr(ast::TypeForm::kVoid, token_span(ctx->start));
  } else {
    out->result = type(ctx->type());
  }
  RbtParser::BlockContext* body = ctx->block();
  if (ctx->fnBody() != nullptr) body = ctx->fnBody()->block();
  if (body != nullptr) {
    out->body = function_block(body);
  } else {
    out->value = expression(ctx->fnBody()->expression());
  }
  return out;
}

ast::Stmt* AstBuilder::struct_decl(RbtParser::StructDeclContext* ctx) {
  auto* out = fresh<ast::StructStmt>(ast::StmtKind::kStruct, span_of(ctx));
  out->name = name(ctx->name());
  std::vector<ast::Param> fields;
  for (RbtParser::ParamContext* field : ctx->param()) fields.push_back(param(field));
  out->fields = in_.arena.copy(fields);
  out->doc = doc(ctx);
  return out;
}

ast::Stmt* AstBuilder::enum_decl(RbtParser::EnumDeclContext* ctx) {
  auto* out = fresh<ast::EnumStmt>(ast::StmtKind::kEnum, span_of(ctx));
  out->name = name(ctx->name(0));
  std::vector<ast::Name> values;
  for (RbtParser::NameContext* value : ctx->name()) values.push_back(name(value));
  values.erase(values.begin());  // the enum's own name
  out->values = in_.arena.copy(values);
  out->doc = doc(ctx);
  return out;
}

ast::Stmt* AstBuilder::import_decl(RbtParser::ImportDeclContext* ctx) {
  auto* out = fresh<ast::ImportStmt>(ast::StmtKind::kImport, span_of(ctx));
  out->is_file = ctx->STRING() != nullptr;
  if (out->is_file) {
    out->path_span = token_span(ctx->STRING()->getSymbol());
    out->path = decoded(out->path_span);
  } else {
    out->path_span = span_of(ctx->typeName());
    std::string path;  // without the blanks and comments between its names
    for (RbtParser::NameContext* part : ctx->typeName()->name())
      path.append(path.empty() ? "" : ".").append(name(part).text);
    out->path = in_.arena.copy(path);
  }
  if (ctx->name() != nullptr) out->alias = name(ctx->name());
  return out;
}

ast::Stmt* AstBuilder::test_decl(RbtParser::TestDeclContext* ctx) {
  auto* out = fresh<ast::TestStmt>(ast::StmtKind::kTest, span_of(ctx));
  out->name_span = token_span(ctx->STRING()->getSymbol());
  out->name = decoded(out->name_span);
  out->body = body_block(ctx->block(), {.at_top = false});
  return out;
}

// The text of the /// lines directly above `ctx`, without their marks.
std::string_view AstBuilder::doc(const antlr4::ParserRuleContext* ctx) {
  const std::size_t first = ctx->start->getTokenIndex();
  const std::uint32_t below = first == 0 ? 0 : in_.tokens[first - 1].end;
  const std::uint32_t above = in_.tokens[first].begin;
  const auto from = std::ranges::lower_bound(in_.comments, below, {}, &Span::begin);
  std::string out;
  for (auto at = from; at != in_.comments.end() && at->begin < above; ++at) {
    std::string_view line = text(*at);
    const std::uint32_t start = in_.source.line_start(in_.source.position(at->begin).line);
    const bool alone =
        text({start, at->begin, at->source}).find_first_not_of(" \t") == std::string_view::npos;
    if (!alone || !line.starts_with(kDocMark)) {
      out.clear();
      continue;
    }
    line.remove_prefix(kDocMark.size());
    if (line.starts_with(' ')) line.remove_prefix(1);
    if (!out.empty()) out += '\n';
    out += line;
  }
  return in_.arena.copy(out);
}

}  // namespace armlet::lang
