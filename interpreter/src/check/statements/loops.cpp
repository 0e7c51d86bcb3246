// while, do, for.

#include <algorithm>

#include "check/checker.hpp"
#include "check/statements/recordings.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {
namespace {

bool is_always_true(const hir::Expr* condition) {
  return condition == nullptr ||
         (condition->kind == hir::ExprKind::kBool && condition->as<hir::BoolExpr>().value);
}

hir::Variable* loop_variable(Checker& checker, const ast::Name& name, const Type* type) {
  checker.is_free(name);
  hir::Variable* variable = checker.new_variable(name.text, type, name.span);
  variable->fixed = true;
  checker.add_local(variable, Declared::kLoop, name.span);
  return variable;
}

// for (i, x in xs), for (c in text): a loop over the places of the value as it is at the start.
hir::Stmt* loop_over_places(Checker& checker, const ast::ForInStmt& stmt, hir::Expr* items) {
  const Span span = items->span;
  const bool is_text = items->type->is(Kind::kText);
  const Type* element = is_text ? items->type : items->type->element;
  hir::Variable* all = checker.hidden(items->type, span);
  all->init = items;
  const auto read_all = [&] {
    return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, all->type, span, all);
  };
  auto* loop = checker.make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr,
                                            nullptr, nullptr, nullptr);
  loop->first = checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types_.integer(), span,
                                           std::int64_t{0});
  loop->last = checker.make<hir::LengthExpr>(hir::ExprKind::kLength, checker.types_.integer(), span,
                                             read_all());
  checker.open_block();
  loop->variable = stmt.index.text.empty()
                       ? checker.hidden(checker.types_.integer(), stmt.name.span)
                       : loop_variable(checker, stmt.index, checker.types_.integer());
  hir::Expr* place = checker.make<hir::VariableExpr>(
      hir::ExprKind::kVariable, checker.types_.integer(), stmt.name.span, loop->variable);
  hir::Variable* variable = loop_variable(checker, stmt.name, element);
  hir::Expr* value = nullptr;
  if (is_text) {
    value = checker.make<hir::CharacterExpr>(hir::ExprKind::kCharacter, element, span, read_all(),
                                             place);
  } else {
    value =
        checker.make<hir::ElementExpr>(hir::ExprKind::kElement, element, span, read_all(), place);
  }
  hir::Stmt* body = checker.loop_body(loop, *stmt.body, false);
  const std::vector<hir::Stmt*> pass = {
      checker.make<hir::InitStmt>(hir::StmtKind::kInit, stmt.name.span, variable, value), body};
  loop->body = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.body->span, checker.seq(pass));
  checker.close_block();
  const std::vector<hir::Stmt*> both = {
      checker.make<hir::InitStmt>(hir::StmtKind::kInit, span, all, items), loop};
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(both));
}

// for (k, v in m): a loop over the entries of the map as it is at the start.
hir::Stmt* loop_over_entries(Checker& checker, const ast::ForInStmt& stmt, hir::Expr* items) {
  const Span span = items->span;
  std::vector<hir::Stmt*> out;
  const auto kept = [&](hir::Expr* value) {
    hir::Variable* variable = checker.hidden(value->type, span);
    variable->init = value;
    out.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, span, variable, value));
    return variable;
  };
  const auto read = [&](hir::Variable* variable) {
    return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span,
                                           variable);
  };
  const Type* integer = checker.types_.integer();
  hir::Variable* map = kept(items);
  hir::Variable* keys = kept(parts_of_map(checker, hir::MapQuestion::kKeys, read(map), span));
  hir::Variable* values = kept(parts_of_map(checker, hir::MapQuestion::kValues, read(map), span));
  auto* loop = checker.make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr,
                                            nullptr, nullptr, nullptr);
  loop->first = checker.make<hir::IntExpr>(hir::ExprKind::kInt, integer, span, std::int64_t{0});
  loop->last = checker.make<hir::LengthExpr>(hir::ExprKind::kLength, integer, span, read(keys));
  checker.open_block();
  loop->variable = checker.hidden(integer, stmt.name.span);
  std::vector<hir::Stmt*> pass;
  const auto element = [&](const ast::Name& name, hir::Variable* list) {
    hir::Variable* variable = loop_variable(checker, name, list->type->element);
    hir::Expr* value = checker.make<hir::ElementExpr>(hir::ExprKind::kElement, variable->type, span,
                                                      read(list), read(loop->variable), nullptr);
    pass.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, name.span, variable, value));
  };
  element(stmt.index, keys);
  element(stmt.name, values);
  pass.push_back(checker.loop_body(loop, *stmt.body, false));
  loop->body = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.body->span, checker.seq(pass));
  checker.close_block();
  out.push_back(loop);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(out));
}

}  // namespace

hir::Stmt* Checker::check_loop(const ast::Stmt& stmt) {
  if (stmt.kind == ast::StmtKind::kDo) return check_do(stmt.as<ast::DoStmt>());
  if (stmt.kind == ast::StmtKind::kForIn) return check_for_in(stmt.as<ast::ForInStmt>());
  if (stmt.kind == ast::StmtKind::kFor) return check_for(stmt.as<ast::ForStmt>());
  const auto& loop = stmt.as<ast::WhileStmt>();
  return check_while(loop.condition, *loop.body, {}, stmt.span);
}

// The body of a loop that may run not even once, and the state behind it. endless: only break
// leaves.
hir::Stmt* Checker::loop_body(const hir::Stmt* loop, const ast::Stmt& body, bool endless) {
  const Flow before = here_->flow;
  here_->targets.push_back({JumpTarget::Kind::kLoop, loop});
  sink_.begin_statement();
  open_block();
  hir::Stmt* out = check_statement(body);
  close_block();
  Flow after = before;
  if (endless) after.reachable = false;
  after.merge(merged(std::move(here_->targets.back().exits)));
  here_->targets.pop_back();
  here_->flow = std::move(after);
  if (out == nullptr)
    out = make<hir::Block>(hir::StmtKind::kBlock, body.span, hir::Seq<hir::Stmt*>{});
  return out;
}

hir::Stmt* Checker::check_while(const ast::Expr* condition_expr, const ast::Stmt& body,
                                ast::Seq<ast::Stmt*> step, Span span) {
  auto* loop = make<hir::LoopStmt>(hir::StmtKind::kLoop, span, nullptr, nullptr, nullptr, true);
  loop->condition = condition_expr != nullptr ? condition(*condition_expr) : nullptr;
  loop->body = loop_body(loop, body, is_always_true(loop->condition));
  if (step.empty()) return loop;
  const Flow after = here_->flow;
  here_->flow.reachable = true;
  std::vector<hir::Stmt*> steps;
  for (const ast::Stmt* stmt : step) {
    sink_.begin_statement();
    if (hir::Stmt* checked = check_statement(*stmt)) steps.push_back(checked);
  }
  here_->flow = after;
  loop->step = make<hir::Block>(hir::StmtKind::kBlock, span, seq(steps));
  return loop;
}

hir::Stmt* Checker::check_do(const ast::DoStmt& stmt) {
  auto* loop =
      make<hir::LoopStmt>(hir::StmtKind::kLoop, stmt.span, nullptr, nullptr, nullptr, false);
  // The body runs at least once, so what it stores on every way to the condition is stored.
  here_->targets.push_back({JumpTarget::Kind::kLoop, loop});
  loop->body = check_block(stmt.body->body, stmt.body->span);
  here_->flow.merge(merged(std::move(here_->targets.back().repeats)));
  Flow after = here_->flow;
  sink_.begin_statement();
  loop->condition = condition(*stmt.condition);
  if (is_always_true(loop->condition)) after.reachable = false;
  after.merge(merged(std::move(here_->targets.back().exits)));
  here_->targets.pop_back();
  here_->flow = std::move(after);
  return loop;
}

hir::Stmt* Checker::check_for(const ast::ForStmt& stmt) {
  std::vector<hir::Stmt*> body;
  open_block();
  for (const ast::Stmt* init : stmt.init) {
    if (hir::Stmt* checked = check_statement(*init)) append(*init, checked, body);
  }
  body.push_back(check_while(stmt.condition, *stmt.body, stmt.step, stmt.span));
  close_block();
  return make<hir::Block>(hir::StmtKind::kBlock, stmt.span, seq(body));
}

hir::Stmt* Checker::check_range(const ast::ForInStmt& stmt, const ast::CallExpr& range) {
  auto* loop = make<hir::RangeStmt>(hir::StmtKind::kRange, stmt.span, nullptr, nullptr, nullptr,
                                    nullptr, nullptr);
  mentioned_.insert("range");
  std::vector<hir::Expr*> bounds;
  for (std::size_t i = 0; i < range.args.size(); ++i) {
    bounds.push_back(check_as(*range.args[i].value, {.role = Target::Role::kArgument,
                                                     .type = types_.integer(),
                                                     .name = "bound",
                                                     .function = "range",
                                                     .position = static_cast<int>(i) + 1}));
  }
  loop->first = bounds.size() > 1 ? bounds[0]
                                  : make<hir::IntExpr>(hir::ExprKind::kInt, types_.integer(),
                                                       range.span, std::int64_t{0});
  loop->last = bounds.size() > 1 ? bounds[1] : bounds[0];
  loop->step = bounds.size() > 2 ? bounds[2] : nullptr;
  open_block();
  loop->variable = loop_variable(*this, stmt.name, types_.integer());
  loop->body = loop_body(loop, *stmt.body, false);
  close_block();
  return loop;
}

hir::Stmt* Checker::check_for_in(const ast::ForInStmt& stmt) {
  if (stmt.items->kind == ast::ExprKind::kCall) {
    const auto& call = stmt.items->as<ast::CallExpr>();
    const bool plain = stmt.type == nullptr || resolve(*stmt.type)->is(Kind::kInt);
    const bool named =
        std::ranges::any_of(call.args, [](const ast::Arg& arg) { return !arg.name.text.empty(); });
    if (plain && !named && stmt.index.text.empty() && dotted_name(*call.callee) == "range" &&
        find_function("range") == nullptr && !call.args.empty() && call.args.size() <= 3) {
      return check_range(stmt, call);
    }
  }
  const Type* wanted = stmt.type != nullptr ? resolve(*stmt.type) : nullptr;
  hir::Expr* items = check_value(*stmt.items, wanted != nullptr ? types_.list(wanted) : nullptr);
  if (items->type->is(Kind::kMatrix)) {
    const Type* rows = types_.list(types_.list(types_.real()));
    items = make<hir::ConvertExpr>(hir::ExprKind::kConvert, rows, items->span,
                                   hir::Conversion::kMatrixToRows, items);
  }
  if (items->type->is_table()) items = rows_of(*this, items);
  if (items->type->is(Kind::kMap) && !items->type->element->is(Kind::kAny)) {
    if (!stmt.index.text.empty()) return loop_over_entries(*this, stmt, items);
    items = parts_of_map(*this, hir::MapQuestion::kKeys, items, items->span);
  }
  if (items->type->is(Kind::kText) && wanted == nullptr)
    return loop_over_places(*this, stmt, items);
  if (!items->type->is(Kind::kList) && !items->type->is(Kind::kAny)) {
    Diagnostic diagnostic = make_diagnostic("E0331", items->span, {type_phrase(items->type)});
    if (items->type->is(Kind::kInt)) {
      const std::string range = "range(" + text_of(items->span) + ")";
      diagnostic.fix = Fix{.text = "write " + range,
                           .edits = {{items->span, range}},
                           .confidence = Confidence::kSure};
    }
    report(std::move(diagnostic));
    items = failed(items->span);
  }
  if (wanted != nullptr && !items->type->is(Kind::kAny)) {
    items = require(items, {.type = types_.list(wanted), .name = stmt.name.text});
  }
  const bool known = items->type->is(Kind::kList) && !items->type->element->is(Kind::kAny);
  if (items->type->is(Kind::kList) && !known)
    report(make_diagnostic("E0323", items->span, {"this empty list"}));
  if (known && !stmt.index.text.empty()) return loop_over_places(*this, stmt, items);
  auto* loop =
      make<hir::ForListStmt>(hir::StmtKind::kForList, stmt.span, nullptr, nullptr, nullptr);
  loop->items = items;
  open_block();
  if (!stmt.index.text.empty()) loop_variable(*this, stmt.index, types_.integer());
  loop->variable = loop_variable(*this, stmt.name,
                                 known               ? items->type->element
                                 : wanted != nullptr ? wanted
                                                     : types_.any());
  loop->body = loop_body(loop, *stmt.body, false);
  close_block();
  return loop;
}

}  // namespace armlet::lang
