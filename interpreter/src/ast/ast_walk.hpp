#pragma once
// Visits the direct parts of the nodes of the syntax tree.

#include "ast/ast.hpp"

namespace armlet::lang::ast {

// Calls on_expr(const Expr&) and on_stmt(const Stmt&) for the direct children of a node, in the
// order of the text. The bodies of lambdas and functions count as statements.
template <class E, class S>
class Parts {
 public:
  Parts(E& on_expr, S& on_stmt) : on_expr_(on_expr), on_stmt_(on_stmt) {}

  template <class Node, class... Members>
  void of(const Node& node, Members... members) {
    (part(node.*members), ...);
  }

 private:
  void part(const Expr* expr) {
    if (expr != nullptr) on_expr_(*expr);
  }
  void part(const Stmt* stmt) {
    if (stmt != nullptr) on_stmt_(*stmt);
  }
  // These parts contain neither expressions nor statements.
  void part(const Span&) {}
  void part(const Name&) {}
  void part(std::string_view) {}
  void part(const TypeExpr*) {}
  void part(const Arg& arg) { part(arg.value); }
  void part(const FormatPiece& piece) { part(piece.value); }
  void part(const IndexItem& item) { of(item, &IndexItem::first, &IndexItem::last); }
  void part(const Param& param) { part(param.default_value); }
  void part(const Declarator& declarator) { part(declarator.init); }
  void part(const BlockItem& item) { of(item, &BlockItem::value, &BlockItem::args); }
  void part(const SwitchCase& one) { of(one, &SwitchCase::values, &SwitchCase::body); }
  void part(const CatchClause& clause) { part(clause.body); }
  template <class T>
  void part(Seq<T> items) {
    for (const auto& item : items) part(item);
  }

  E& on_expr_;
  S& on_stmt_;
};

template <class E, class S>
void for_each_part(const Expr& expr, E on_expr, S on_stmt) {
  Parts<E, S> parts(on_expr, on_stmt);
  switch (expr.kind) {
#define ARMLET_STMT(...)
#define ARMLET_EXPR(kind, Node, ...) \
  case ExprKind::kind:               \
    return parts.of(expr.as<Node>() __VA_OPT__(, ) __VA_ARGS__);
#include "ast/ast_nodes.def"
#undef ARMLET_EXPR
#undef ARMLET_STMT
  }
}

template <class E, class S>
void for_each_part(const Stmt& stmt, E on_expr, S on_stmt) {
  Parts<E, S> parts(on_expr, on_stmt);
  switch (stmt.kind) {
#define ARMLET_EXPR(...)
#define ARMLET_STMT(kind, Node, ...) \
  case StmtKind::kind:               \
    return parts.of(stmt.as<Node>() __VA_OPT__(, ) __VA_ARGS__);
#include "ast/ast_nodes.def"
#undef ARMLET_STMT
#undef ARMLET_EXPR
  }
}

}  // namespace armlet::lang::ast
