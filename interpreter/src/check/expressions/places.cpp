#include "check/expressions/places.hpp"

#include <algorithm>

#include "check/calls/fields.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/expressions/host_places.hpp"
#include "check/expressions/matrices.hpp"
#include "check/expressions/operators.hpp"
#include "check/library/formatted.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/indices.hpp"
#include "check/types/maps.hpp"
#include "check/types/types.hpp"
#include "hir/analysis.hpp"

namespace armlet::lang {

namespace {

std::optional<hir::Step> check_place_step(Checker& checker, const ast::Expr& at, const Type* type,
                                          Span whole);
hir::Stmt* assign_one(Checker& checker, const ast::Expr& target, const ast::AssignStmt& assign);
hir::Stmt* assign_many(Checker& checker, const ast::AssignStmt& assign);
hir::Stmt* assign_compound(Checker& checker, const ast::AssignStmt& assign);

const ast::Expr& root_of(const ast::Expr& expr) {
  const ast::Expr* at = &expr;
  for (;;) {
    if (at->kind == ast::ExprKind::kMember) {
      at = at->as<ast::MemberExpr>().object;
    } else if (at->kind == ast::ExprKind::kIndex) {
      at = at->as<ast::IndexExpr>().object;
    } else {
      return *at;
    }
  }
}

}  // namespace

// void fill(double[] a) { a[0] = 1.0; }: only the copy of the argument would change.
namespace {

void report_copy(Checker& checker, const Local& local, Span statement) {
  const std::string name(local.variable->name);
  Diagnostic diagnostic = make_diagnostic("E0308", statement, {name});
  diagnostic.why = "values are copied when they are passed to a function";
  const FunctionContext& root = checker.scopes.here().root();
  if (root.kind == FunctionContext::Kind::kNamed && &checker.scopes.here() == &root) {
    const ast::FunctionStmt& node = *root.declaration->node;
    std::string parameters;
    for (const ast::Param& param : node.params) {
      parameters += (parameters.empty() ? "" : ", ") + checker.text_of(param.span);
    }
    const std::string copy = name == "r" ? "out" : "r";
    std::string changed = checker.text_of(statement);
    if (changed.starts_with(name)) changed.replace(0, name.size(), copy);
    if (changed.ends_with(';')) changed.pop_back();
    const std::string type = type_name(local.variable->type);
    const std::string head = std::string(node.name.text) + '(' + parameters + ')';
    diagnostic.fix =
        Fix{.text = "return the changed " +
                    std::string(local.variable->type->is(Kind::kList) ? "list" : "value") + ": " +
                    (node.classic ? type + ' ' + head : "fn " + head + " -> " + type) + " { var " +
                    copy + " = " + name + "; " + changed + "; return " + copy + "; }"};
  }
  checker.report(std::move(diagnostic));
}

// whole: the variable gets a new value; otherwise only a part of it changes.
bool may_change(Checker& checker, Local& local, FunctionContext& where, Span statement,
                bool whole) {
  const std::string name(local.variable->name);
  // Lambdas between the current function and the variable have copies.
  for (const FunctionContext* context = &checker.scopes.here();
       context != &where && context != nullptr; context = context->outer) {
    if (context->kind != FunctionContext::Kind::kLambda) continue;
    Diagnostic diagnostic = make_diagnostic("E0210", statement, {name});
    diagnostic.related.push_back({local.variable->declared, "declared here"});
    checker.report(std::move(diagnostic));
    return false;
  }
  if (local.how == Declared::kParameter) {
    report_copy(checker, local, statement);
    return false;
  }
  // A `let x: T` without a value gets its only value later.
  if (!local.variable->fixed ||
      (whole && &where == &checker.scopes.here() && where.flow.is_unset(local.variable)))
    return true;
  Diagnostic diagnostic = make_diagnostic("E0206", statement, {name});
  switch (local.how) {
    case Declared::kLet:
    case Declared::kFinal: {
      diagnostic.related.push_back({local.keyword, local.how == Declared::kLet
                                                       ? "declared with let"
                                                       : "declared with final"});
      if (local.keyword.source < checker.into.sources->first()) {  // that entry has run already
        diagnostic.fix = Fix{.text = "declare it again: var " + name + " = " + name};
        break;
      }
      const std::string line = std::to_string(checker.line_of(local.variable->declared));
      diagnostic.fix =
          Fix{.text = local.how == Declared::kLet ? "declare it with var on line " + line
                                                  : "delete final on line " + line,
              .edits = {{local.keyword, local.how == Declared::kLet ? "var" : ""}}};
      break;
    }
    case Declared::kLoop:
      diagnostic.related.push_back({local.variable->declared, "the loop gives it its values"});
      break;
    case Declared::kVar:
    case Declared::kClassic:
    case Declared::kParameter:
    case Declared::kCatch:
    case Declared::kBlock:
    case Declared::kCapture:
      diagnostic.related.push_back({local.variable->declared, "declared here"});
      break;
  }
  checker.report(std::move(diagnostic));
  return false;
}

// Reports a target `expr` that starts with `root`, which is not a variable.
void refuse_place(Checker& checker, const ast::Expr& root, const ast::Expr& expr, Span statement) {
  if (root.kind == ast::ExprKind::kName &&
      checker.names.find_import(root.as<ast::NameExpr>().name) != nullptr) {
    refuse_change(checker, expr, statement);
    return;
  }
  const std::string_view name =
      root.kind == ast::ExprKind::kName ? root.as<ast::NameExpr>().name : std::string_view();
  const bool is_type = !name.empty() && type_called(checker, name) != nullptr;
  if (!name.empty() && !is_type && checker.names.find_function(name) == nullptr &&
      checker.registry.functions(name).empty() && checker.registry.constant(name) == nullptr) {
    unknown_variable(checker, root, expr, statement);
    return;
  }
  Diagnostic diagnostic = make_diagnostic("E0328", expr.span);
  if (is_type) {
    diagnostic.why = '`' + std::string(name) + "` is a type; the name of the variable is missing";
    checker.messages.set_syntax_failed();
  } else if (!name.empty() && &root == &expr) {
    if (!checker.messages.is_first(name)) return;
    const Span begin{statement.begin, statement.begin, statement.source};
    const bool own = checker.names.find_function(name) != nullptr;
    const bool stores = checker.text_of(statement).find("+=") == std::string::npos;
    diagnostic.why = '`' + std::string(name) +
                     (own ? "` is a function" : "` is a name of the library; no variable has it");
    if (stores && !own)
      diagnostic.fix =
          Fix{.text = "write var " + checker.text_of(statement), .edits = {{begin, "var "}}};
  }
  checker.report(std::move(diagnostic));
}

}  // namespace

std::optional<hir::Place> Checker::check_place(const ast::Expr& expr, Span statement, bool whole) {
  std::vector<const ast::Expr*> chain;
  for (const ast::Expr* at = &expr; at != &root_of(expr);) {
    chain.push_back(at);
    at = at->kind == ast::ExprKind::kMember ? at->as<ast::MemberExpr>().object
                                            : at->as<ast::IndexExpr>().object;
  }
  const ast::Expr& root = root_of(expr);
  FunctionContext* where = nullptr;
  Local* local = root.kind == ast::ExprKind::kName
                     ? scopes.find(root.as<ast::NameExpr>().name, where)
                     : nullptr;
  if (local == nullptr) {
    refuse_place(*this, root, expr, statement);
    return std::nullopt;
  }
  if (shared.learnt != nullptr) shared.learnt->use(root.span, local->variable->declared);
  const bool is_whole = whole && chain.empty();
  const Type* type = local->variable->type;
  if (type->is(Kind::kAny)) return std::nullopt;
  const bool has_parts = type->is(Kind::kList) || type->is(Kind::kRecord) ||
                         type->is(Kind::kMatrix) || type->is(Kind::kMap);
  if (!chain.empty() && !has_parts) {
    report(make_diagnostic("E0328", expr.span));
    return std::nullopt;
  }
  if (!may_change(*this, *local, *where, statement, is_whole)) return std::nullopt;
  hir::Variable* variable = local->variable;
  if (is_whole && where != &scopes.here()) {
    variable = captured(*this, *local, *where, scopes.here());
  } else if (!is_whole) {
    const hir::Expr* value = read(*this, *local, *where, root.span);
    if (value->type->is(Kind::kAny)) return std::nullopt;
    variable = value->as<hir::VariableExpr>().variable;
  }
  hir::Place place{variable, {}, variable->type, expr.span};
  std::vector<hir::Step> steps;
  std::ranges::reverse(chain);
  for (const ast::Expr* at : chain) {
    const auto step = check_place_step(*this, *at, place.type, expr.span);
    if (!step) return std::nullopt;
    place.type = step->type;
    steps.push_back(*step);
  }
  place.steps = seq(steps);
  return place;
}

namespace {

// Checks one field or element of an assignment target of type `type`; whole: the expression of the
// target.
std::optional<hir::Step> check_place_step(Checker& checker, const ast::Expr& at, const Type* type,
                                          Span whole) {
  hir::Step step{};
  step.span = at.span;
  if (at.kind == ast::ExprKind::kMember) {
    const ast::Name& field = at.as<ast::MemberExpr>().member;
    if (type->is_table()) {
      Diagnostic diagnostic = make_diagnostic("E0328", whole);
      diagnostic.why = "a table holds what was recorded";
      diagnostic.fix = Fix{.text = "copy the column: var copy = " + checker.text_of(at.span)};
      checker.report(std::move(diagnostic));
      return std::nullopt;
    }
    const int i = type->is(Kind::kRecord)
                      ? checker.shared.structs.field_index(*type->record, field.text)
                      : -1;
    if (i < 0 && type->is(Kind::kRecord)) {
      unknown_field(checker,
                    hir::Expr{.kind = hir::ExprKind::kVariable, .type = type, .span = at.span},
                    field);
    } else if (i < 0) {
      Diagnostic diagnostic = make_diagnostic("E0328", whole);
      if (type->is(Kind::kList) && field.text == "last") {
        const std::string list = checker.text_of(at.as<ast::MemberExpr>().object->span);
        const std::string element = list + '[' + list + ".length - 1]";
        diagnostic.fix = Fix{.text = "write " + element, .edits = {{at.span, element}}};
      }
      if (type->is(Kind::kMap)) diagnostic.fix = fix_of_map_member(checker, type, field);
      checker.report(std::move(diagnostic));
    }
    if (i < 0) return std::nullopt;
    note_field_use(checker, *type, static_cast<std::size_t>(i), field.span);
    step.is_field = true;
    step.field = static_cast<std::uint32_t>(i);
    step.type = type->record->fields[i].type;
    return step;
  }
  const auto& index = at.as<ast::IndexExpr>();
  if (type->is(Kind::kMatrix)) return matrix_step(checker, index);
  if (is_part(index)) {
    refuse_element_of_part(checker, index);
    return std::nullopt;
  }
  if (index.items.size() != 1) {
    checker.report(make_diagnostic("E0318", at.span, {"with a comma, " + type_phrase(type)}));
    return std::nullopt;
  }
  if (type->is(Kind::kMap)) return entry_step(checker, index, type);
  if (!type->is(Kind::kList)) {
    checker.report(make_diagnostic("E0328", whole));
    return std::nullopt;
  }
  step.index = index_value(checker, *index.items[0].first, {.object = index.object->span});
  step.type = type->element;
  return step;
}

}  // namespace

// ---- assignments -------------------------------------------------------------------------------

ast::BinaryExpr operation_of(const ast::AssignStmt& assign, const ast::Expr& target) {
  ast::BinaryExpr node{};
  node.kind = ast::ExprKind::kBinary;
  node.span = assign.span;
  node.op = assign.op;
  node.left = const_cast<ast::Expr*>(&target);
  node.right = assign.value;
  node.op_span = {assign.op_span.begin, assign.op_span.begin + 1, assign.op_span.source};
  return node;
}

hir::Stmt* check_assign(Checker& checker, const ast::AssignStmt& assign) {
  if (assign.compound) return assign_compound(checker, assign);
  if (assign.targets.size() > 1) return assign_many(checker, assign);
  return assign_one(checker, *assign.targets[0], assign);
}

namespace {

hir::Stmt* assign_one(Checker& checker, const ast::Expr& target, const ast::AssignStmt& assign) {
  if (is_part(target)) return assign_part(checker, target.as<ast::IndexExpr>(), assign);
  if (is_host_part(checker, target))
    return store_host_part(checker, target, checker.check_value(*assign.value), assign);
  const auto place = checker.check_place(target, assign.span, true);
  if (!place) {
    checker.check(*assign.value);
    return nullptr;
  }
  hir::Expr* value =
      checker.check_as(*assign.value, {.type = place->type, .name = place->variable->name});
  advise_on_divided_remark(checker, *assign.value, *value, place->type);
  if (place->steps.empty()) note_assigned(checker.scopes.here(), place->variable);
  return checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, value, false,
                                       hir::Op::kAddI, assign.op_span);
}

// One of several targets of an assignment.
struct ManyTarget {
  const ast::Expr* written;
  std::optional<hir::Place> place{};  // empty: `part` is set, or a part of a host value
  std::optional<PartStore> part{};

  [[nodiscard]] const Type* type() const {
    if (place) return place->type;
    return part ? part->wanted.type : nullptr;
  }
};

std::optional<ManyTarget> check_target(Checker& checker, const ast::Expr& target, Span statement) {
  ManyTarget out{.written = &target};
  if (is_host_part(checker, target)) return out;
  if (is_part(target)) {
    out.part = check_part(checker, target.as<ast::IndexExpr>(), statement);
    if (!out.part) return std::nullopt;
  } else {
    out.place = checker.check_place(target, statement, true);
    if (!out.place) return std::nullopt;
  }
  return out;
}

hir::Stmt* store_copy(Checker& checker, const ManyTarget& target, hir::Expr* copy,
                      const ast::AssignStmt& assign) {
  if (target.part) {
    return fill_part(checker, *target.part, checker.require(copy, target.part->wanted),
                     target.written->span);
  }
  if (!target.place) return store_host_part(checker, *target.written, copy, assign);
  const hir::Place& place = *target.place;
  copy = checker.require(copy, {.type = place.type, .name = place.variable->name});
  if (place.steps.empty()) note_assigned(checker.scopes.here(), place.variable);
  return checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, place, copy, false,
                                       hir::Op::kAddI, assign.op_span);
}

// a = b = e: evaluates e once, then assigns from right to left.
hir::Stmt* assign_many(Checker& checker, const ast::AssignStmt& assign) {
  std::vector<ManyTarget> targets;
  for (const ast::Expr* target : assign.targets) {
    const auto checked = check_target(checker, *target, assign.span);
    if (!checked) return nullptr;
    targets.push_back(*checked);
  }
  const Type* last = targets.back().type();
  hir::Expr* value = checker.check_value(*assign.value, last);
  if (value->type->is(Kind::kAny)) return nullptr;
  if (value->kind == hir::ExprKind::kList && last != nullptr)
    value = checker.require(value, {.type = last});
  hir::Variable* once = hidden(checker, value->type, assign.value->span);
  once->init = value;
  std::vector<hir::Stmt*> body = {
      checker.make<hir::InitStmt>(hir::StmtKind::kInit, assign.span, once, value)};
  for (std::size_t i = targets.size(); i-- > 0;) {
    hir::Expr* copy = is_zero(*value)
                          ? value
                          : checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, once->type,
                                                            value->span, once);
    if (hir::Stmt* stored = store_copy(checker, targets[i], copy, assign)) body.push_back(stored);
  }
  return checker.make<hir::Block>(hir::StmtKind::kBlock, assign.span, checker.seq(body));
}

}  // namespace

hir::Expr* read_place(Checker& checker, const hir::Place& place) {
  hir::Expr* value = checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, place.variable->type,
                                                     place.span, place.variable);
  for (const hir::Step& step : place.steps) {
    if (step.map != nullptr) {
      value = checker.make<hir::EntryExpr>(hir::ExprKind::kEntry, step.type, step.span, value,
                                           step.index, nullptr);
    } else if (step.is_field) {
      value = checker.make<hir::FieldExpr>(hir::ExprKind::kField, step.type, step.span, value,
                                           step.field);
    } else {
      value = checker.make<hir::ElementExpr>(hir::ExprKind::kElement, step.type, step.span, value,
                                             step.index, step.column);
    }
  }
  return value;
}

namespace {

hir::Stmt* assign_compound(Checker& checker, const ast::AssignStmt& assign) {
  const ast::Expr& target = *assign.targets[0];
  if (is_part(target)) return assign_part(checker, target.as<ast::IndexExpr>(), assign);
  if (is_host_part(checker, target)) return change_host_part(checker, target, assign);
  const auto place = checker.check_place(target, assign.span, false);
  if (!place) {
    checker.check(*assign.value);
    return nullptr;
  }
  std::vector<hir::Stmt*> before;
  const bool numbers = place->type->is_number();
  if (!numbers) {
    // The target occurs twice in the result, so the values of its indices are stored.
    for (hir::Step& step : place->steps) {
      evaluate_once(checker, step.index, before);
    }
  }
  hir::Expr* value = checker.check_value(*assign.value);
  if (!numbers && !is_quiet(*value)) {
    hir::Variable* once = hidden(checker, value->type, value->span);
    once->init = value;
    before.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, value->span, once, value));
    value =
        checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, once->type, value->span, once);
  }
  hir::Expr* old = read_place(checker, *place);
  const ast::BinaryExpr node = operation_of(assign, target);
  const bool text = place->type->is(Kind::kText) && assign.op == ast::BinaryOp::kAdd;
  if (text && !value->type->is(Kind::kAny)) {
    const std::vector<hir::Expr*> parts = {old, to_text(checker, value)};
    value = checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types.text(), assign.span,
                                          checker.seq(parts));
  } else {
    hir::Expr* result = combine(checker, node, old, value);
    if (result->type->is(Kind::kAny)) return nullptr;
    result = checker.require(result, {.type = place->type, .name = place->variable->name});
    if (result->type->is(Kind::kAny)) return nullptr;
    if (numbers && result->kind == hir::ExprKind::kBinary) {
      const auto& sum = result->as<hir::BinaryExpr>();
      return checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, sum.right,
                                           true, sum.op, assign.op_span);
    }
    value = result;
  }
  hir::Stmt* store = checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place,
                                                   value, false, hir::Op::kAddI, assign.op_span);
  if (before.empty()) return store;
  before.push_back(store);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, assign.span, checker.seq(before));
}

}  // namespace

hir::Stmt* check_step(Checker& checker, const ast::StepStmt& step) {
  const auto place = checker.check_place(*step.target, step.span, false);
  if (!place) return nullptr;
  if (!place->type->is(Kind::kInt) && !place->type->is_double()) {
    checker.report(
        make_diagnostic("E0317", step.span, {step.up ? "++" : "--", type_phrase(place->type)}));
    return nullptr;
  }
  const bool whole = place->type->is(Kind::kInt);
  hir::Expr* one =
      whole ? static_cast<hir::Expr*>(checker.make<hir::IntExpr>(hir::ExprKind::kInt, place->type,
                                                                 step.span, std::int64_t{1}))
            : checker.make<hir::RealExpr>(hir::ExprKind::kReal, place->type, step.span, 1.0);
  const hir::Op up = whole ? hir::Op::kAddI : hir::Op::kAddR;
  const hir::Op down = whole ? hir::Op::kSubI : hir::Op::kSubR;
  return checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, step.span, *place, one, true,
                                       step.up ? up : down, step.span);
}

}  // namespace armlet::lang
