// Builds lists, matrices and maps.

#include "syntax/build/build_ast.hpp"

namespace armlet::lang {

// [a, b] is a list; any `;`, also after the last row, makes a matrix; colons make a map.
ast::Expr* AstBuilder::list_or_matrix(RbtParser::PrimaryContext* ctx) {
  const Span span = span_of(ctx);
  if (ctx->COLON() != nullptr) return map_of(span, {});
  std::vector<std::vector<Item>> rows;
  bool is_map = false;
  for (RbtParser::RowContext* row : ctx->row()) {
    std::vector<Item>& items = rows.emplace_back();
    for (RbtParser::ItemContext* item : row->item()) {
      const bool has_key = item->COLON() != nullptr;
      items.push_back(
          {expression(item->expression(0)), has_key ? expression(item->expression(1)) : nullptr});
      is_map = is_map || has_key;
    }
  }
  if (is_map) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      rows[0].insert(rows[0].end(), rows[i].begin(), rows[i].end());
    }
    if (!ctx->SEMI().empty()) {
      Diagnostic message = make_diagnostic("E0134", token_span(ctx->SEMI(0)->getSymbol()));
      message.fix = Fix{.text = "write a comma", .edits = {{message.mark.span, ","}}};
      report(std::move(message));
    }
    return map_of(span, rows[0]);
  }
  std::vector<ast::Seq<ast::Expr*>> values;
  for (const std::vector<Item>& row : rows) values.push_back(firsts_of(row));
  if (!ctx->SEMI().empty()) {
    auto* matrix = fresh<ast::MatrixExpr>(ast::ExprKind::kMatrix, span);
    matrix->rows = in_.arena.copy(values);
    return matrix;
  }
  auto* list = fresh<ast::ListExpr>(ast::ExprKind::kList, span);
  if (!values.empty()) list->items = values.front();
  return list;
}

ast::Expr* AstBuilder::brace_init(RbtParser::BraceInitContext* ctx) {
  const Deeper deeper(*this, 1, span_of(ctx));
  std::vector<Item> items;
  bool is_map = false;
  for (RbtParser::BraceItemContext* item : ctx->braceItem()) {
    const bool has_key = item->COLON() != nullptr;
    items.push_back(
        {initializer(item->initializer(0)), has_key ? initializer(item->initializer(1)) : nullptr});
    is_map = is_map || has_key;
  }
  if (is_map) return map_of(span_of(ctx), items);
  auto* list = fresh<ast::BraceExpr>(ast::ExprKind::kBrace, span_of(ctx));
  list->items = firsts_of(items);
  return list;
}

ast::Seq<ast::Expr*> AstBuilder::firsts_of(const std::vector<Item>& items) {
  std::vector<ast::Expr*> out;
  for (const Item& item : items) out.push_back(item.first);
  return in_.arena.copy(out);
}

ast::Expr* AstBuilder::map_of(Span span, const std::vector<Item>& items) {
  std::vector<ast::Expr*> keys;
  std::vector<ast::Expr*> values;
  bool complained = false;
  for (const Item& item : items) {
    if (item.second == nullptr) {
      if (!complained) report(make_diagnostic("E0134", item.first->span));
      complained = true;
      continue;
    }
    keys.push_back(item.first);
    values.push_back(item.second);
  }
  auto* map = fresh<ast::MapExpr>(ast::ExprKind::kMap, span);
  map->keys = in_.arena.copy(keys);
  map->values = in_.arena.copy(values);
  return map;
}

}  // namespace armlet::lang
