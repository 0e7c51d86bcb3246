#pragma once
// Visits the direct parts of checked expressions and statements.

#include <vector>

#include "hir/hir.hpp"

namespace armlet::lang {

namespace hir {

// Two lists of equal length whose elements are visited alternately: the first of each, the second
// of each, and so on.
template <class Node>
struct Alternating {
  Seq<Expr*> Node::*first;
  Seq<Expr*> Node::*second;
};
template <class Node>
Alternating<Node> alternating(Seq<Expr*> Node::*first, Seq<Expr*> Node::*second) {
  return {first, second};
}

// Calls on_expr(const Expr&) and on_stmt(const Stmt&) for the direct children of a node, from left
// to right.
template <class E, class S>
class Parts {
 public:
  Parts(E& on_expr, S& on_stmt) : on_expr_(on_expr), on_stmt_(on_stmt) {}

  template <class Node, class... Members>
  void of(const Node& node, Members... members) {
    (member(node, members), ...);
  }
  void part(const Place& place) {
    for (const Step& step : place.steps) of(step, &Step::index, &Step::column);
  }
  void part(const PartEnds& ends) { of(ends, &PartEnds::first, &PartEnds::last); }

 private:
  template <class Node, class T>
  void member(const Node& node, T Node::*member) {
    part(node.*member);
  }
  template <class Node>
  void member(const Node& node, Alternating<Node> pairs) {
    for (std::size_t i = 0; i < (node.*pairs.first).size(); ++i) {
      part((node.*pairs.first)[i]);
      part((node.*pairs.second)[i]);
    }
  }
  void part(const Expr* expr) {
    if (expr != nullptr) on_expr_(*expr);
  }
  void part(const Stmt* stmt) {
    if (stmt != nullptr) on_stmt_(*stmt);
  }
  void part(const SwitchCase& one) { of(one, &SwitchCase::tests, &SwitchCase::body); }
  template <class T>
  void part(Seq<T> items) {
    for (const auto& item : items) part(item);
  }

  E& on_expr_;
  S& on_stmt_;
};

}  // namespace hir

// Calls f(const hir::Expr&) for each expression directly inside an assignment target, or inside the
// ends of a part.
template <class F>
void for_each_index(const hir::Place& place, F f) {
  const auto none = [](const hir::Stmt&) {};
  hir::Parts(f, none).part(place);
}
template <class F>
void for_each_end(const hir::PartEnds& ends, F f) {
  const auto none = [](const hir::Stmt&) {};
  hir::Parts(f, none).part(ends);
}

// Calls f(const hir::Expr&) for each operand of an expression, from left to right. Bodies of
// functions are not entered.
template <class F>
void for_each_operand(const hir::Expr& expr, F f) {
  using namespace hir;
  const auto none = [](const Stmt&) {};
  Parts parts(f, none);
  switch (expr.kind) {
#define ARMLET_STMT(...)
#define ARMLET_EXPR(kind, Node, ...) \
  case ExprKind::kind:               \
    return parts.of(expr.as<Node>() __VA_OPT__(, ) __VA_ARGS__);
#include "hir/hir_nodes.def"
#undef ARMLET_EXPR
#undef ARMLET_STMT
  }
}

// Calls on_expr(const hir::Expr&) for each expression and on_stmt(const hir::Stmt&) for each
// statement directly inside.
template <class E, class S>
void for_each_child(const hir::Stmt& stmt, E on_expr, S on_stmt) {
  using namespace hir;
  Parts parts(on_expr, on_stmt);
  switch (stmt.kind) {
#define ARMLET_EXPR(...)
#define ARMLET_STMT(kind, Node, ...) \
  case StmtKind::kind:               \
    return parts.of(stmt.as<Node>() __VA_OPT__(, ) __VA_ARGS__);
#include "hir/hir_nodes.def"
#undef ARMLET_STMT
#undef ARMLET_EXPR
  }
}

// Whether `claim` holds for the expression or any part of it. The walk is not recursive, so long
// chains need no stack.
template <class F>
bool any_part(const hir::Expr& expr, F claim) {
  std::vector<const hir::Expr*> open{&expr};
  while (!open.empty()) {
    const hir::Expr& e = *open.back();
    open.pop_back();
    if (claim(e)) return true;
    for_each_operand(e, [&](const hir::Expr& operand) { open.push_back(&operand); });
  }
  return false;
}

}  // namespace armlet::lang
