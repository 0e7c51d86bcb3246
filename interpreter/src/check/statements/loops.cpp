#include "check/statements/loops.hpp"

#include <algorithm>

#include "check/calls/tables.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/statements/loop_advice.hpp"
#include "check/statements/statements.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {

namespace {

hir::Stmt* loop_body(Checker& checker, const hir::Stmt* loop, const ast::Stmt& body, bool endless);
hir::Stmt* check_while(Checker& checker, const ast::Expr* condition, const ast::Stmt& body,
                       ast::Seq<ast::Stmt*> step, Span span);
hir::Stmt* check_do(Checker& checker, const ast::DoStmt& stmt);
hir::Stmt* check_for(Checker& checker, const ast::ForStmt& stmt);
hir::Stmt* check_for_in(Checker& checker, const ast::ForInStmt& stmt);

bool is_always_true(const hir::Expr* condition) {
  return condition == nullptr ||
         (condition->kind == hir::ExprKind::kBool && condition->as<hir::BoolExpr>().value);
}

hir::Variable* loop_variable(Checker& checker, const ast::Name& name, const Type* type) {
  is_free(checker, name);
  hir::Variable* variable = new_variable(checker, name.text, type, name.span);
  variable->fixed = true;
  checker.scopes.add(variable, Declared::kLoop, name.span);
  return variable;
}

// for (i, x in xs), for (c in text): a loop over the indices of a copy of the value.
hir::Stmt* loop_over_places(Checker& checker, const ast::ForInStmt& stmt, hir::Expr* items) {
  const Span span = items->span;
  const bool is_text = items->type->is(Kind::kText);
  const Type* element = is_text ? items->type : items->type->element;
  hir::Variable* all = hidden(checker, items->type, span);
  all->init = items;
  const auto read_all = [&] {
    return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, all->type, span, all);
  };
  auto* loop = checker.make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr,
                                            nullptr, nullptr, nullptr);
  loop->first = checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(), span,
                                           std::int64_t{0});
  loop->last = checker.make<hir::LengthExpr>(hir::ExprKind::kLength, checker.types.integer(), span,
                                             read_all());
  checker.scopes.open_block();
  loop->variable = stmt.index.text.empty()
                       ? hidden(checker, checker.types.integer(), stmt.name.span)
                       : loop_variable(checker, stmt.index, checker.types.integer());
  hir::Expr* place = checker.make<hir::VariableExpr>(
      hir::ExprKind::kVariable, checker.types.integer(), stmt.name.span, loop->variable);
  hir::Variable* variable = loop_variable(checker, stmt.name, element);
  hir::Expr* value = nullptr;
  if (is_text) {
    value = checker.make<hir::CharacterExpr>(hir::ExprKind::kCharacter, element, span, read_all(),
                                             place);
  } else {
    value =
        checker.make<hir::ElementExpr>(hir::ExprKind::kElement, element, span, read_all(), place);
  }
  hir::Stmt* body = loop_body(checker, loop, *stmt.body, false);
  const std::vector<hir::Stmt*> pass = {
      checker.make<hir::InitStmt>(hir::StmtKind::kInit, stmt.name.span, variable, value), body};
  loop->body = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.body->span, checker.seq(pass));
  close_block(checker);
  const std::vector<hir::Stmt*> both = {
      checker.make<hir::InitStmt>(hir::StmtKind::kInit, span, all, items), loop};
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(both));
}

// for (k, v in m): a loop over the entries of a copy of the map.
hir::Stmt* loop_over_entries(Checker& checker, const ast::ForInStmt& stmt, hir::Expr* items) {
  const Span span = items->span;
  std::vector<hir::Stmt*> out;
  const auto kept = [&](hir::Expr* value) {
    hir::Variable* variable = hidden(checker, value->type, span);
    variable->init = value;
    out.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, span, variable, value));
    return variable;
  };
  const auto read = [&](hir::Variable* variable) {
    return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span,
                                           variable);
  };
  const Type* integer = checker.types.integer();
  hir::Variable* map = kept(items);
  hir::Variable* keys = kept(parts_of_map(checker, hir::MapQuestion::kKeys, read(map), span));
  hir::Variable* values = kept(parts_of_map(checker, hir::MapQuestion::kValues, read(map), span));
  auto* loop = checker.make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr,
                                            nullptr, nullptr, nullptr);
  loop->first = checker.make<hir::IntExpr>(hir::ExprKind::kInt, integer, span, std::int64_t{0});
  loop->last = checker.make<hir::LengthExpr>(hir::ExprKind::kLength, integer, span, read(keys));
  checker.scopes.open_block();
  loop->variable = hidden(checker, integer, stmt.name.span);
  std::vector<hir::Stmt*> pass;
  const auto element = [&](const ast::Name& name, hir::Variable* list) {
    hir::Variable* variable = loop_variable(checker, name, list->type->element);
    hir::Expr* value = checker.make<hir::ElementExpr>(hir::ExprKind::kElement, variable->type, span,
                                                      read(list), read(loop->variable), nullptr);
    pass.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, name.span, variable, value));
  };
  element(stmt.index, keys);
  element(stmt.name, values);
  pass.push_back(loop_body(checker, loop, *stmt.body, false));
  loop->body = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.body->span, checker.seq(pass));
  close_block(checker);
  out.push_back(loop);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(out));
}

}  // namespace

hir::Stmt* check_loop(Checker& checker, const ast::Stmt& stmt) {
  if (stmt.kind == ast::StmtKind::kDo) return check_do(checker, stmt.as<ast::DoStmt>());
  if (stmt.kind == ast::StmtKind::kForIn) return check_for_in(checker, stmt.as<ast::ForInStmt>());
  if (stmt.kind == ast::StmtKind::kFor) return check_for(checker, stmt.as<ast::ForStmt>());
  const auto& loop = stmt.as<ast::WhileStmt>();
  return check_while(checker, loop.condition, *loop.body, {}, stmt.span);
}

namespace {

// The body of a loop that may run not even once, and the state after the loop. endless: only break
// ends it.
hir::Stmt* loop_body(Checker& checker, const hir::Stmt* loop, const ast::Stmt& body, bool endless) {
  const Flow before = checker.scopes.here().flow;
  checker.scopes.here().targets.push_back({JumpTarget::Kind::kLoop, loop});
  checker.messages.begin_statement();
  checker.scopes.open_block();
  hir::Stmt* out = checker.check_statement(body);
  close_block(checker);
  Flow after = before;
  if (endless) after.reachable = false;
  after.merge(merged(std::move(checker.scopes.here().targets.back().exits)));
  checker.scopes.here().targets.pop_back();
  checker.scopes.here().flow = std::move(after);
  if (out == nullptr)
    out = checker.make<hir::Block>(hir::StmtKind::kBlock, body.span, hir::Seq<hir::Stmt*>{});
  return out;
}

hir::Stmt* check_while(Checker& checker, const ast::Expr* condition_expr, const ast::Stmt& body,
                       ast::Seq<ast::Stmt*> step, Span span) {
  auto* loop =
      checker.make<hir::LoopStmt>(hir::StmtKind::kLoop, span, nullptr, nullptr, nullptr, true);
  loop->condition = condition_expr != nullptr ? checker.condition(*condition_expr) : nullptr;
  loop->body = loop_body(checker, loop, body, is_always_true(loop->condition));
  if (step.empty()) return loop;
  const Flow after = checker.scopes.here().flow;
  checker.scopes.here().flow.reachable = true;
  std::vector<hir::Stmt*> steps;
  for (const ast::Stmt* stmt : step) {
    checker.messages.begin_statement();
    if (hir::Stmt* checked = checker.check_statement(*stmt)) steps.push_back(checked);
  }
  checker.scopes.here().flow = after;
  loop->step = checker.make<hir::Block>(hir::StmtKind::kBlock, span, checker.seq(steps));
  return loop;
}

hir::Stmt* check_do(Checker& checker, const ast::DoStmt& stmt) {
  auto* loop = checker.make<hir::LoopStmt>(hir::StmtKind::kLoop, stmt.span, nullptr, nullptr,
                                           nullptr, false);
  // The body runs at least once, so variables that it assigns on every path to the condition have
  // values.
  checker.scopes.here().targets.push_back({JumpTarget::Kind::kLoop, loop});
  loop->body = checker.check_block(stmt.body->body, stmt.body->span);
  checker.scopes.here().flow.merge(merged(std::move(checker.scopes.here().targets.back().repeats)));
  Flow after = checker.scopes.here().flow;
  checker.messages.begin_statement();
  loop->condition = checker.condition(*stmt.condition);
  if (is_always_true(loop->condition)) after.reachable = false;
  after.merge(merged(std::move(checker.scopes.here().targets.back().exits)));
  checker.scopes.here().targets.pop_back();
  checker.scopes.here().flow = std::move(after);
  return loop;
}

hir::Stmt* check_for(Checker& checker, const ast::ForStmt& stmt) {
  std::vector<hir::Stmt*> body;
  checker.scopes.open_block();
  for (const ast::Stmt* init : stmt.init) {
    if (hir::Stmt* checked = checker.check_statement(*init)) append(*init, checked, body);
  }
  body.push_back(check_while(checker, stmt.condition, *stmt.body, stmt.step, stmt.span));
  advise_summed_steps(checker, stmt);
  close_block(checker);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(body));
}

// Whether a range has quantities: range(0mm, 100mm, 10mm) is a list from the library.
bool counts_quantities(const std::vector<hir::Expr*>& bounds) {
  return bounds.size() == 3 && std::ranges::any_of(bounds, [](const hir::Expr* bound) {
           return bound->type->is(Kind::kReal);
         });
}

hir::Stmt* check_range(Checker& checker, const ast::ForInStmt& stmt, const ast::CallExpr& range,
                       std::vector<hir::Expr*> bounds) {
  auto* loop = checker.make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr,
                                            nullptr, nullptr, nullptr);
  checker.shared.mentions.add("range");
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    bounds[i] = checker.require(bounds[i], {.role = Target::Role::kArgument,
                                            .type = checker.types.integer(),
                                            .name = "bound",
                                            .function = "range",
                                            .position = static_cast<int>(i) + 1});
  }
  loop->first = bounds.size() > 1
                    ? bounds[0]
                    : checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(),
                                                 range.span, std::int64_t{0});
  loop->last = bounds.size() > 1 ? bounds[1] : bounds[0];
  loop->step = bounds.size() > 2 ? bounds[2] : nullptr;
  checker.scopes.open_block();
  loop->variable = loop_variable(checker, stmt.name, checker.types.integer());
  loop->body = loop_body(checker, loop, *stmt.body, false);
  close_block(checker);
  return loop;
}

// A loop over range(...) of ints, which needs no list; null if it is another loop.
hir::Stmt* check_counting(Checker& checker, const ast::ForInStmt& stmt) {
  if (stmt.items->kind != ast::ExprKind::kCall) return nullptr;
  const auto& call = stmt.items->as<ast::CallExpr>();
  const bool plain = stmt.type == nullptr || checker.resolve(*stmt.type)->is(Kind::kInt);
  const bool named =
      std::ranges::any_of(call.args, [](const ast::Arg& arg) { return !arg.name.text.empty(); });
  const bool is_range = plain && !named && stmt.index.text.empty() &&
                        dotted_name(checker, *call.callee) == "range" &&
                        checker.names.find_function("range") == nullptr && !call.args.empty() &&
                        call.args.size() <= 3;
  if (!is_range) return nullptr;
  std::vector<hir::Expr*> bounds;
  for (const ast::Arg& arg : call.args)
    bounds.push_back(checker.check_value(*arg.value, checker.types.integer()));
  return counts_quantities(bounds) ? nullptr : check_range(checker, stmt, call, std::move(bounds));
}

hir::Stmt* check_for_in(Checker& checker, const ast::ForInStmt& stmt) {
  if (hir::Stmt* counting = check_counting(checker, stmt)) return counting;
  const Type* wanted = stmt.type != nullptr ? checker.resolve(*stmt.type) : nullptr;
  hir::Expr* items =
      checker.check_value(*stmt.items, wanted != nullptr ? checker.types.list(wanted) : nullptr);
  if (items->type->is(Kind::kMatrix)) {
    const Type* rows = checker.types.list(checker.types.list(checker.types.real()));
    items = checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, rows, items->span,
                                           hir::Conversion::kMatrixToRows, items);
  }
  if (items->type->is_table()) items = rows_of(checker, items);
  if (items->type->is(Kind::kMap) && !items->type->element->is(Kind::kAny)) {
    if (!stmt.index.text.empty()) return loop_over_entries(checker, stmt, items);
    items = parts_of_map(checker, hir::MapQuestion::kKeys, items, items->span);
  }
  if (items->type->is(Kind::kText) && wanted == nullptr)
    return loop_over_places(checker, stmt, items);
  if (!items->type->is(Kind::kList) && !items->type->is(Kind::kAny)) {
    Diagnostic diagnostic = make_diagnostic("E0331", items->span, {type_phrase(items->type)});
    if (items->type->is(Kind::kInt)) {
      const std::string range = "range(" + checker.text_of(items->span) + ")";
      diagnostic.fix = Fix{.text = "write " + range,
                           .edits = {{items->span, range}},
                           .confidence = Confidence::kSure};
    }
    checker.report(std::move(diagnostic));
    items = checker.failed(items->span);
  }
  if (wanted != nullptr && !items->type->is(Kind::kAny)) {
    items = checker.require(items, {.type = checker.types.list(wanted), .name = stmt.name.text});
  }
  const bool known = items->type->is(Kind::kList) && !items->type->element->is(Kind::kAny);
  if (items->type->is(Kind::kList) && !known)
    checker.report(make_diagnostic("E0323", items->span, {"this empty list"}));
  if (known && !stmt.index.text.empty()) return loop_over_places(checker, stmt, items);
  auto* loop =
      checker.make<hir::ForListStmt>(hir::StmtKind::kForList, stmt.span, nullptr, nullptr, nullptr);
  loop->items = items;
  checker.scopes.open_block();
  if (!stmt.index.text.empty()) loop_variable(checker, stmt.index, checker.types.integer());
  loop->variable = loop_variable(checker, stmt.name,
                                 known               ? items->type->element
                                 : wanted != nullptr ? wanted
                                                     : checker.types.any());
  loop->body = loop_body(checker, loop, *stmt.body, false);
  close_block(checker);
  return loop;
}

}  // namespace

}  // namespace armlet::lang
