// What stands in front of `=`: variables, elements and fields that can be changed.

#include <algorithm>

#include "armlet/interpreter/later.hpp"
#include "check/checker.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/names/host_places.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/statements/tasks.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"
#include "check/types/matrices.hpp"
#include "compile/lower/analysis.hpp"

namespace armlet::lang {

namespace {

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

// void fill(double[] a) { a[0] = 1.0; }: only the copy would change.
void Checker::report_copy(const Local& local, Span statement) {
  const std::string name(local.variable->name);
  Diagnostic diagnostic = make_diagnostic("E0308", statement, {name});
  diagnostic.why = "values are copied when they are passed to a function";
  const FunctionContext& root = here_->root();
  if (root.kind == FunctionContext::Kind::kNamed && here_ == &root) {
    const ast::FunctionStmt& node = *root.declaration->node;
    std::string parameters;
    for (const ast::Param& param : node.params) {
      parameters += (parameters.empty() ? "" : ", ") + text_of(param.span);
    }
    const std::string copy = name == "r" ? "out" : "r";
    std::string changed = text_of(statement);
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
  report(std::move(diagnostic));
}

// whole: the variable itself gets a new value; otherwise a part of it changes.
bool Checker::may_change(Local& local, FunctionContext& where, Span statement, bool whole) {
  const std::string name(local.variable->name);
  // Lambdas between here and the variable hold copies.
  for (const FunctionContext* context = here_; context != &where && context != nullptr;
       context = context->outer) {
    if (context->kind != FunctionContext::Kind::kLambda) continue;
    Diagnostic diagnostic = make_diagnostic("E0210", statement, {name});
    diagnostic.related.push_back({local.variable->declared, "declared here"});
    report(std::move(diagnostic));
    return false;
  }
  if (local.how == Declared::kParameter) {
    report_copy(local, statement);
    return false;
  }
  // let x: T without a value gets its only value later.
  if (!local.variable->fixed || (whole && &where == here_ && where.flow.is_unset(local.variable)))
    return true;
  Diagnostic diagnostic = make_diagnostic("E0206", statement, {name});
  switch (local.how) {
    case Declared::kLet:
    case Declared::kFinal: {
      diagnostic.related.push_back({local.keyword, local.how == Declared::kLet
                                                       ? "declared with let"
                                                       : "declared with final"});
      const std::string line = std::to_string(line_of(local.variable->declared));
      diagnostic.fix =
          Fix{.text = local.how == Declared::kLet ? "declare it with var on line " + line
                                                  : "delete final on line " + line,
              .edits = {{local.keyword, local.how == Declared::kLet ? "var" : ""}}};
      break;
    }
    case Declared::kLoop:
      diagnostic.related.push_back({local.variable->declared, "the loop gives it its values"});
      break;
    default:
      diagnostic.related.push_back({local.variable->declared, "declared here"});
      break;
  }
  report(std::move(diagnostic));
  return false;
}

// `root` is the start of the place `expr`, and no variable.
void Checker::refuse_place(const ast::Expr& root, const ast::Expr& expr, Span statement) {
  if (root.kind == ast::ExprKind::kName &&
      find_import(*this, root.as<ast::NameExpr>().name) != nullptr) {
    refuse_change(*this, expr, statement);
    return;
  }
  const std::string_view name =
      root.kind == ast::ExprKind::kName ? root.as<ast::NameExpr>().name : std::string_view();
  const bool is_type = !name.empty() && type_called(name) != nullptr;
  if (!name.empty() && !is_type && find_function(name) == nullptr &&
      registry_.functions(name).empty() && registry_.constant(name) == nullptr) {
    unknown_variable(*this, root, expr, statement);
    return;
  }
  Diagnostic diagnostic = make_diagnostic("E0328", expr.span);
  if (is_type) {
    diagnostic.why = '`' + std::string(name) + "` is a type; the name of the variable is missing";
    syntax_failed_ = true;
  } else if (!name.empty() && &root == &expr) {
    if (!told_.emplace(name).second) return;
    const Span begin{statement.begin, statement.begin, statement.source};
    const bool own = find_function(name) != nullptr;
    const bool stores = text_of(statement).find("+=") == std::string::npos;
    diagnostic.why = '`' + std::string(name) +
                     (own ? "` is a function" : "` is a name of the library; no variable has it");
    if (stores && !own)
      diagnostic.fix = Fix{.text = "write var " + text_of(statement), .edits = {{begin, "var "}}};
  }
  report(std::move(diagnostic));
}

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
                     ? find_local(root.as<ast::NameExpr>().name, where)
                     : nullptr;
  if (local == nullptr) {
    refuse_place(root, expr, statement);
    return std::nullopt;
  }
  const bool is_whole = whole && chain.empty();
  const Type* type = local->variable->type;
  if (type->is(Kind::kAny)) return std::nullopt;
  const bool has_parts = type->is(Kind::kList) || type->is(Kind::kRecord) ||
                         type->is(Kind::kMatrix) || type->is(Kind::kMap);
  if (!chain.empty() && !has_parts) {
    report(make_diagnostic("E0328", expr.span));
    return std::nullopt;
  }
  if (!may_change(*local, *where, statement, is_whole)) return std::nullopt;
  hir::Variable* variable = local->variable;
  if (is_whole && where != here_) {
    variable = captured(*local, *where, *here_);
  } else if (!is_whole) {
    const hir::Expr* value = read(*local, *where, root.span);
    if (value->type->is(Kind::kAny)) return std::nullopt;
    variable = value->as<hir::VariableExpr>().variable;
  }
  hir::Place place{variable, {}, variable->type, expr.span};
  std::vector<hir::Step> steps;
  std::ranges::reverse(chain);
  for (const ast::Expr* at : chain) {
    const auto step = check_place_step(*at, place.type, expr.span);
    if (!step) return std::nullopt;
    place.type = step->type;
    steps.push_back(*step);
  }
  place.steps = seq(steps);
  return place;
}

// One field or element of a place of type `type`; whole: the place as written.
std::optional<hir::Step> Checker::check_place_step(const ast::Expr& at, const Type* type,
                                                   Span whole) {
  hir::Step step{};
  step.span = at.span;
  if (at.kind == ast::ExprKind::kMember) {
    const ast::Name& field = at.as<ast::MemberExpr>().member;
    if (type->is_table()) {
      Diagnostic diagnostic = make_diagnostic("E0328", whole);
      diagnostic.why = "a table holds what was recorded";
      diagnostic.fix = Fix{.text = "copy the column: var copy = " + text_of(at.span)};
      report(std::move(diagnostic));
      return std::nullopt;
    }
    const int i = type->is(Kind::kRecord) ? field_index(*this, *type->record, field.text) : -1;
    if (i < 0 && type->is(Kind::kRecord)) {
      unknown_field(hir::Expr{.kind = hir::ExprKind::kVariable, .type = type, .span = at.span},
                    field);
    } else if (i < 0) {
      Diagnostic diagnostic = make_diagnostic("E0328", whole);
      if (type->is(Kind::kList) && field.text == "last") {
        const std::string list = text_of(at.as<ast::MemberExpr>().object->span);
        const std::string element = list + '[' + list + ".length - 1]";
        diagnostic.fix = Fix{.text = "write " + element, .edits = {{at.span, element}}};
      }
      if (type->is(Kind::kMap)) diagnostic.fix = fix_of_map_member(*this, type, field);
      report(std::move(diagnostic));
    }
    if (i < 0) return std::nullopt;
    step.is_field = true;
    step.field = static_cast<std::uint32_t>(i);
    step.type = type->record->fields[i].type;
    return step;
  }
  const auto& index = at.as<ast::IndexExpr>();
  if (type->is(Kind::kMatrix)) return matrix_step(*this, index);
  if (index.items.size() != 1 || index.items[0].is_range) {
    not_available(at.span, kStoringPlaces);
    return std::nullopt;
  }
  if (type->is(Kind::kMap)) return entry_step(*this, index, type);
  if (!type->is(Kind::kList)) {
    report(make_diagnostic("E0328", whole));
    return std::nullopt;
  }
  step.index = index_value(*index.items[0].first);
  step.type = type->element;
  return step;
}

// ---- assignments -------------------------------------------------------------------------------

hir::Stmt* Checker::check_assign(const ast::AssignStmt& assign) {
  if (assign.compound) return assign_compound(assign);
  if (assign.targets.size() > 1) return assign_many(assign);
  return assign_one(*assign.targets[0], assign);
}

hir::Stmt* Checker::assign_one(const ast::Expr& target, const ast::AssignStmt& assign) {
  if (is_part(target)) return assign_part(*this, target.as<ast::IndexExpr>(), assign);
  if (is_host_part(*this, target))
    return store_host_part(*this, target, check_value(*assign.value), assign);
  const auto place = check_place(target, assign.span, true);
  if (!place) {
    check(*assign.value);
    return nullptr;
  }
  hir::Expr* value = check_as(*assign.value, {.type = place->type, .name = place->variable->name});
  advise_on_divided_remark(*this, *assign.value, *value, place->type);
  if (place->steps.empty()) note_assigned(*here_, place->variable);
  return make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, value, false,
                               hir::Op::kAddI, assign.op_span);
}

// a = b = e: e once, then from right to left.
hir::Stmt* Checker::assign_many(const ast::AssignStmt& assign) {
  std::vector<std::optional<hir::Place>> places;  // empty: a part of a host value
  for (const ast::Expr* target : assign.targets) {
    places.push_back(is_host_part(*this, *target) ? std::nullopt
                                                  : check_place(*target, assign.span, true));
    if (!places.back() && !is_host_part(*this, *target)) return nullptr;
  }
  const Type* last = places.back() ? places.back()->type : nullptr;
  hir::Expr* value = check_value(*assign.value, last);
  if (value->type->is(Kind::kAny)) return nullptr;
  if (value->kind == hir::ExprKind::kList && last != nullptr)
    value = require(value, {.type = last});
  hir::Variable* once = hidden(value->type, assign.value->span);
  once->init = value;
  std::vector<hir::Stmt*> body = {
      make<hir::InitStmt>(hir::StmtKind::kInit, assign.span, once, value)};
  for (std::size_t i = places.size(); i-- > 0;) {
    const std::optional<hir::Place>& place = places[i];
    hir::Expr* copy = is_zero(*value) ? value
                                      : make<hir::VariableExpr>(hir::ExprKind::kVariable,
                                                                once->type, value->span, once);
    if (!place) {
      if (hir::Stmt* stored = store_host_part(*this, *assign.targets[i], copy, assign))
        body.push_back(stored);
      continue;
    }
    copy = require(copy, {.type = place->type, .name = place->variable->name});
    if (place->steps.empty()) note_assigned(*here_, place->variable);
    body.push_back(make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, copy, false,
                                         hir::Op::kAddI, assign.op_span));
  }
  return make<hir::Block>(hir::StmtKind::kBlock, assign.span, seq(body));
}

hir::Expr* Checker::read_place(const hir::Place& place) {
  hir::Expr* value = make<hir::VariableExpr>(hir::ExprKind::kVariable, place.variable->type,
                                             place.span, place.variable);
  for (const hir::Step& step : place.steps) {
    if (step.map != nullptr) {
      value = make<hir::EntryExpr>(hir::ExprKind::kEntry, step.type, step.span, value, step.index,
                                   nullptr);
    } else if (step.is_field) {
      value = make<hir::FieldExpr>(hir::ExprKind::kField, step.type, step.span, value, step.field);
    } else {
      value = make<hir::ElementExpr>(hir::ExprKind::kElement, step.type, step.span, value,
                                     step.index, step.column);
    }
  }
  return value;
}

hir::Stmt* Checker::assign_compound(const ast::AssignStmt& assign) {
  const ast::Expr& target = *assign.targets[0];
  if (is_part(target)) return assign_part(*this, target.as<ast::IndexExpr>(), assign);
  if (is_host_part(*this, target)) return change_host_part(*this, target, assign);
  const auto place = check_place(target, assign.span, false);
  if (!place) {
    check(*assign.value);
    return nullptr;
  }
  std::vector<hir::Stmt*> before;
  const bool numbers = place->type->is_number();
  if (!numbers) {
    // The place is written twice, so what its indexes compute is kept.
    for (hir::Step& step : place->steps) {
      evaluate_once(*this, step.index, before);
    }
  }
  hir::Expr* value = check_value(*assign.value);
  if (!numbers && !is_quiet(*value)) {
    hir::Variable* once = hidden(value->type, value->span);
    once->init = value;
    before.push_back(make<hir::InitStmt>(hir::StmtKind::kInit, value->span, once, value));
    value = make<hir::VariableExpr>(hir::ExprKind::kVariable, once->type, value->span, once);
  }
  hir::Expr* old = read_place(*place);
  ast::BinaryExpr node{};
  node.kind = ast::ExprKind::kBinary;
  node.span = assign.span;
  node.op = assign.op;
  node.left = const_cast<ast::Expr*>(&target);
  node.right = assign.value;
  node.op_span = {assign.op_span.begin, assign.op_span.begin + 1, assign.op_span.source};
  const bool text = place->type->is(Kind::kText) && assign.op == ast::BinaryOp::kAdd;
  if (text && !value->type->is(Kind::kAny)) {
    const std::vector<hir::Expr*> parts = {old, to_text(value)};
    value = make<hir::ConcatExpr>(hir::ExprKind::kConcat, types_.text(), assign.span, seq(parts));
  } else {
    hir::Expr* result = combine(node, old, value);
    if (result->type->is(Kind::kAny)) return nullptr;
    result = require(result, {.type = place->type, .name = place->variable->name});
    if (result->type->is(Kind::kAny)) return nullptr;
    if (numbers && result->kind == hir::ExprKind::kBinary) {
      const auto& sum = result->as<hir::BinaryExpr>();
      return make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, sum.right, true,
                                   sum.op, assign.op_span);
    }
    value = result;
  }
  hir::Stmt* store = make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, *place, value,
                                           false, hir::Op::kAddI, assign.op_span);
  if (before.empty()) return store;
  before.push_back(store);
  return make<hir::Block>(hir::StmtKind::kBlock, assign.span, seq(before));
}

hir::Stmt* Checker::check_step(const ast::StepStmt& step) {
  const auto place = check_place(*step.target, step.span, false);
  if (!place) return nullptr;
  if (!place->type->is(Kind::kInt) && !place->type->is_double()) {
    report(make_diagnostic("E0317", step.span, {step.up ? "++" : "--", type_phrase(place->type)}));
    return nullptr;
  }
  const bool whole = place->type->is(Kind::kInt);
  hir::Expr* one = whole ? static_cast<hir::Expr*>(make<hir::IntExpr>(
                               hir::ExprKind::kInt, place->type, step.span, std::int64_t{1}))
                         : make<hir::RealExpr>(hir::ExprKind::kReal, place->type, step.span, 1.0);
  const hir::Op up = whole ? hir::Op::kAddI : hir::Op::kAddR;
  const hir::Op down = whole ? hir::Op::kSubI : hir::Op::kSubR;
  return make<hir::AssignStmt>(hir::StmtKind::kAssign, step.span, *place, one, true,
                               step.up ? up : down, step.span);
}

}  // namespace armlet::lang
