#pragma once
// Visits the parts of checked expressions and statements.

#include <vector>

#include "check/hir.hpp"

namespace armlet::lang {

// Calls f(const hir::Expr&) for each expression directly inside a place.
template <class F>
void for_each_index(const hir::Place& place, F f) {
  for (const hir::Step& step : place.steps) {
    if (step.index != nullptr) f(*step.index);
    if (step.column != nullptr) f(*step.column);
  }
}

template <class F>
void for_each_end(const hir::PartEnds& ends, F f) {
  if (ends.first != nullptr) f(*ends.first);
  if (ends.last != nullptr) f(*ends.last);
}

template <class F>
void for_each_operand_of_map(const hir::Expr& e, F f) {
  if (e.kind == hir::ExprKind::kMap) {
    const auto& map = e.as<hir::MapExpr>();
    for (std::size_t i = 0; i < map.keys.size(); ++i) {
      f(*map.keys[i]);
      f(*map.values[i]);
    }
  } else if (e.kind == hir::ExprKind::kEntry) {
    const auto& entry = e.as<hir::EntryExpr>();
    f(*entry.object);
    f(*entry.key);
    if (entry.otherwise != nullptr) f(*entry.otherwise);
  } else if (e.kind == hir::ExprKind::kMapQuery) {
    const auto& query = e.as<hir::MapQueryExpr>();
    f(*query.object);
    if (query.key != nullptr) f(*query.key);
  }
}

// The operands of expressions that have any number of them, or may lack some.
template <class F>
void for_each_listed_operand(const hir::Expr& e, F f) {
  using hir::ExprKind;
  const auto all = [&](hir::Seq<hir::Expr*> items) {
    for (const hir::Expr* item : items) f(*item);
  };
  const auto maybe = [&](const hir::Expr* item) {
    if (item != nullptr) f(*item);
  };
  switch (e.kind) {
    case ExprKind::kList:
      all(e.as<hir::ListExpr>().items);
      break;
    case ExprKind::kNewArray:
      all(e.as<hir::NewArrayExpr>().sizes);
      break;
    case ExprKind::kRecord:
      all(e.as<hir::RecordExpr>().fields);
      break;
    case ExprKind::kSlice:
      f(*e.as<hir::SliceExpr>().object);
      maybe(e.as<hir::SliceExpr>().first);
      maybe(e.as<hir::SliceExpr>().last);
      break;
    case ExprKind::kMatrix:
      all(e.as<hir::MatrixExpr>().items);
      break;
    case ExprKind::kPart:
      f(*e.as<hir::PartExpr>().object);
      for_each_end(e.as<hir::PartExpr>().rows, f);
      for_each_end(e.as<hir::PartExpr>().cols, f);
      break;
    case ExprKind::kCall:
      all(e.as<hir::CallExpr>().arguments);
      break;
    case ExprKind::kCallValue:
      f(*e.as<hir::CallValueExpr>().function);
      all(e.as<hir::CallValueExpr>().arguments);
      break;
    case ExprKind::kCallNative:
      all(e.as<hir::CallNativeExpr>().arguments);
      break;
    case ExprKind::kOverList:
      all(e.as<hir::OverListExpr>().operands);
      break;
    case ExprKind::kConcat:
      all(e.as<hir::ConcatExpr>().parts);
      break;
    case ExprKind::kError:
      f(*e.as<hir::ErrorExpr>().message);
      maybe(e.as<hir::ErrorExpr>().kind_text);
      break;
    case ExprKind::kMutate:
      for_each_index(e.as<hir::MutateExpr>().place, f);
      maybe(e.as<hir::MutateExpr>().index);
      maybe(e.as<hir::MutateExpr>().value);
      break;
    default:
      for_each_operand_of_map(e, f);
  }
}

// Calls f(const hir::Expr&) for each operand of an expression, from left to right. Bodies of
// functions are not entered.
template <class F>
void for_each_operand(const hir::Expr& e, F f) {
  using hir::ExprKind;
  switch (e.kind) {
    case ExprKind::kUnary:
      f(*e.as<hir::UnaryExpr>().operand);
      break;
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
      f(*e.as<hir::BinaryExpr>().left);
      f(*e.as<hir::BinaryExpr>().right);
      break;
    case ExprKind::kCond:
      f(*e.as<hir::CondExpr>().condition);
      f(*e.as<hir::CondExpr>().yes);
      f(*e.as<hir::CondExpr>().no);
      break;
    case ExprKind::kConvert:
      f(*e.as<hir::ConvertExpr>().operand);
      break;
    case ExprKind::kField:
      f(*e.as<hir::FieldExpr>().object);
      break;
    case ExprKind::kElement:
      f(*e.as<hir::ElementExpr>().object);
      f(*e.as<hir::ElementExpr>().index);
      if (e.as<hir::ElementExpr>().column != nullptr) f(*e.as<hir::ElementExpr>().column);
      break;
    case ExprKind::kLength:
      f(*e.as<hir::LengthExpr>().object);
      break;
    case ExprKind::kCharacter:
      f(*e.as<hir::CharacterExpr>().object);
      f(*e.as<hir::CharacterExpr>().index);
      break;
    case ExprKind::kToText:
      f(*e.as<hir::ToTextExpr>().value);
      break;
    case ExprKind::kGuarded:
      f(*e.as<hir::GuardedExpr>().motion);
      f(*e.as<hir::GuardedExpr>().condition);
      break;
    default:
      for_each_listed_operand(e, f);
      break;
  }
}

// Whether `claim` holds for the expression or any part of it. Long chains do not nest calls.
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

// The tasks that a statement starts, and what starts them.
template <class E>
void for_each_task(const hir::Stmt& s, E expr) {
  using hir::StmtKind;
  switch (s.kind) {
    case StmtKind::kParallel:
      for (const hir::Expr* branch : s.as<hir::ParallelStmt>().branches) expr(branch);
      break;
    case StmtKind::kWhen:
      expr(s.as<hir::WhenStmt>().condition);
      expr(s.as<hir::WhenStmt>().body);
      break;
    case StmtKind::kEvery:
      expr(s.as<hir::EveryStmt>().period);
      expr(s.as<hir::EveryStmt>().body);
      break;
    default:
      break;
  }
}

// The parts of statements that decide where to go on.
template <class E, class S>
void for_each_child_of_control(const hir::Stmt& s, E expr, S stmt) {
  using hir::StmtKind;
  switch (s.kind) {
    case StmtKind::kIf:
      expr(s.as<hir::IfStmt>().condition);
      stmt(s.as<hir::IfStmt>().yes);
      stmt(s.as<hir::IfStmt>().no);
      break;
    case StmtKind::kLoop:
      expr(s.as<hir::LoopStmt>().condition);
      stmt(s.as<hir::LoopStmt>().body);
      stmt(s.as<hir::LoopStmt>().step);
      break;
    case StmtKind::kRange:
      expr(s.as<hir::RangeStmt>().first);
      expr(s.as<hir::RangeStmt>().last);
      expr(s.as<hir::RangeStmt>().step);
      stmt(s.as<hir::RangeStmt>().body);
      break;
    case StmtKind::kForList:
      expr(s.as<hir::ForListStmt>().items);
      stmt(s.as<hir::ForListStmt>().body);
      break;
    case StmtKind::kSwitch:
      expr(s.as<hir::SwitchStmt>().value);
      for (const hir::SwitchCase& c : s.as<hir::SwitchStmt>().cases) {
        for (const hir::Expr* test : c.tests) expr(test);
        stmt(c.body);
      }
      break;
    case StmtKind::kTry:
      stmt(s.as<hir::TryStmt>().body);
      stmt(s.as<hir::TryStmt>().handler);
      stmt(s.as<hir::TryStmt>().finally);
      break;
    default:
      for_each_task(s, expr);
      break;
  }
}

// Calls on_expr(const hir::Expr&) for each expression and on_stmt(const hir::Stmt&) for each
// statement directly inside.
template <class E, class S>
void for_each_child(const hir::Stmt& s, E on_expr, S on_stmt) {
  using hir::StmtKind;
  const auto expr = [&](const hir::Expr* e) {
    if (e != nullptr) on_expr(*e);
  };
  const auto stmt = [&](const hir::Stmt* child) {
    if (child != nullptr) on_stmt(*child);
  };
  switch (s.kind) {
    case StmtKind::kBlock:
      for (const hir::Stmt* child : s.as<hir::Block>().body) on_stmt(*child);
      break;
    case StmtKind::kInit:
      expr(s.as<hir::InitStmt>().value);
      break;
    case StmtKind::kAssign:
      for_each_index(s.as<hir::AssignStmt>().place, on_expr);
      expr(s.as<hir::AssignStmt>().value);
      break;
    case StmtKind::kStorePart:
      for_each_index(s.as<hir::StorePartStmt>().place, on_expr);
      for_each_end(s.as<hir::StorePartStmt>().rows, on_expr);
      for_each_end(s.as<hir::StorePartStmt>().cols, on_expr);
      expr(s.as<hir::StorePartStmt>().value);
      break;
    case StmtKind::kExpr:
      expr(s.as<hir::ExprStmt>().value);
      break;
    case StmtKind::kThrow:
      expr(s.as<hir::ThrowStmt>().value);
      break;
    case StmtKind::kReturn:
      expr(s.as<hir::ReturnStmt>().value);
      break;
    case StmtKind::kWait:
      expr(s.as<hir::WaitStmt>().duration);
      break;
    case StmtKind::kWaitUntil:
      expr(s.as<hir::WaitUntilStmt>().condition);
      expr(s.as<hir::WaitUntilStmt>().timeout);
      break;
    case StmtKind::kAssert:
      for (const hir::InitStmt* part : s.as<hir::AssertStmt>().parts_init) on_stmt(*part);
      expr(s.as<hir::AssertStmt>().condition);
      expr(s.as<hir::AssertStmt>().note);
      expr(s.as<hir::AssertStmt>().explain);
      break;
    case StmtKind::kAssertThrows:
      expr(s.as<hir::AssertThrowsStmt>().call);
      expr(s.as<hir::AssertThrowsStmt>().kind_text);
      break;
    default:
      for_each_child_of_control(s, expr, stmt);
      break;
  }
}

}  // namespace armlet::lang
