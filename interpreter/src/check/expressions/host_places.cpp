#include "check/expressions/host_places.hpp"

#include <algorithm>

#include "check/calls/fields.hpp"
#include "check/expressions/matrices.hpp"
#include "check/expressions/operators.hpp"
#include "check/expressions/places.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"
#include "check/state/constants.hpp"
#include "check/types/indices.hpp"
#include "hir/analysis.hpp"

namespace armlet::lang {
namespace {

// The type of an assignment target, without a message; null if the expression is none.
const Type* type_of_place(Checker& checker, const ast::Expr& expr) {
  if (expr.kind == ast::ExprKind::kName) {
    FunctionContext* where = nullptr;
    const Local* local = checker.scopes.find(expr.as<ast::NameExpr>().name, where);
    return local == nullptr ? nullptr : local->variable->type;
  }
  if (expr.kind == ast::ExprKind::kMember) {
    const auto& member = expr.as<ast::MemberExpr>();
    const Type* object = type_of_place(checker, *member.object);
    if (object == nullptr || !object->is(Kind::kRecord) || object->is_table()) return nullptr;
    const int i = checker.shared.structs.field_index(*object->record, member.member.text);
    return i < 0 ? nullptr : object->record->fields[static_cast<std::size_t>(i)].type;
  }
  if (expr.kind != ast::ExprKind::kIndex || is_part(expr)) return nullptr;
  const auto& index = expr.as<ast::IndexExpr>();
  const Type* object = type_of_place(checker, *index.object);
  const bool has_elements =
      object != nullptr && (object->is(Kind::kList) || object->is(Kind::kMap));
  return has_elements && index.items.size() == 1 ? object->element : nullptr;
}

const ast::Expr* object_of(const ast::Expr& target) {
  if (target.kind == ast::ExprKind::kMember) return target.as<ast::MemberExpr>().object;
  if (target.kind == ast::ExprKind::kIndex && !is_part(target))
    return target.as<ast::IndexExpr>().object;
  return nullptr;
}

// Whether a library function of that name takes a value and `further` more arguments.
bool has_row(Checker& checker, const std::string& name, std::size_t further) {
  return std::ranges::any_of(checker.registry.functions(name), [&](const NativeFunction* function) {
    return checker.shared.signatures.of(*function).parameters.size() == further + 1;
  });
}

// The library function that reads elements of a value with this count of indices; empty if there is
// none.
std::string element_row(Checker& checker, const Type& type, std::string_view kind,
                        std::size_t indexes) {
  const std::string name = type_name(&type);
  const std::string of_kind = name + '.' + std::string(kind) + "[]";
  if (!kind.empty() && has_row(checker, of_kind, indexes)) return of_kind;
  return has_row(checker, name + "[]", indexes) ? name + "[]" : std::string();
}

// A part of a host value in an assignment target, whose indices are evaluated once.
struct Part {
  hir::Place place;
  std::string name;                   // "point.x", "point[]"
  std::string read;                   // the function that reads it: "image.grey[]"
  std::vector<hir::Expr*> indexes{};  // of an element
  std::vector<hir::Stmt*> before{};
};

// Stores a value in a hidden variable if other code could change it meanwhile.
hir::Expr* kept(Checker& checker, hir::Expr* value, std::vector<hir::Stmt*>& before) {
  if (is_quiet(*value)) return value;
  hir::Variable* once = hidden(checker, value->type, value->span);
  once->init = value;
  before.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, value->span, once, value));
  return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, once->type, value->span, once);
}

std::optional<Part> part_of(Checker& checker, const ast::Expr& target, Span statement) {
  const auto place = checker.check_place(*object_of(target), statement, false);
  if (!place) return std::nullopt;
  Part out{.place = *place};
  std::vector<hir::Step> steps(place->steps.begin(), place->steps.end());
  for (hir::Step& step : steps) {
    evaluate_once(checker, step.index, out.before);
    evaluate_once(checker, step.column, out.before);
  }
  out.place.steps = checker.seq(steps);
  out.name = type_name(place->type);
  if (target.kind == ast::ExprKind::kMember) {
    out.name += '.' + std::string(target.as<ast::MemberExpr>().member.text);
    out.read = out.name;
    return out;
  }
  const auto& items = target.as<ast::IndexExpr>().items;
  const std::string_view kind = place->steps.empty() ? kind_of(*read_place(checker, *place)) : "";
  out.read = element_row(checker, *place->type, kind, items.size());
  out.name += "[]";
  if (out.read.empty()) {
    checker.report(make_diagnostic("E0328", target.span));
    return std::nullopt;
  }
  for (const ast::IndexItem& item : items) {
    hir::Expr* index = index_value(checker, *item.first);
    if (index->type->is(Kind::kAny)) return std::nullopt;
    out.indexes.push_back(kept(checker, index, out.before));
  }
  return out;
}

std::vector<Argument> arguments(Checker& checker, const Part& part, hir::Expr* value) {
  std::vector<Argument> out = {Argument{.value = read_place(checker, part.place)}};
  for (hir::Expr* index : part.indexes) out.push_back(Argument{.value = index});
  if (value != nullptr) out.push_back(Argument{.value = value});
  return out;
}

hir::Stmt* store(Checker& checker, Part& part, const ast::Expr& target, hir::Expr* value,
                 const ast::AssignStmt& assign) {
  const std::string setter = part.name + '=';
  const auto setters = checker.registry.functions(setter);
  const bool is_known =
      target.kind != ast::ExprKind::kMember || !checker.registry.functions(part.name).empty();
  if (setters.empty() && !is_known) {
    hir::Expr* object = read_place(checker, part.place);
    unknown_field(checker, *object, target.as<ast::MemberExpr>().member);
    return nullptr;
  }
  if (setters.empty()) {
    Diagnostic diagnostic = make_diagnostic("E0328", target.span);
    diagnostic.why = '`' + checker.text_of(target.span) + "` is computed when it is read";
    checker.report(std::move(diagnostic));
    return nullptr;
  }
  value = kept(checker, value, part.before);
  hir::Expr* changed = call_native(checker, setter, setters, target.span, target.span,
                                   arguments(checker, part, value));
  if (changed->type->is(Kind::kAny)) return nullptr;
  hir::Stmt* stored =
      checker.make<hir::AssignStmt>(hir::StmtKind::kAssign, assign.span, part.place, changed, false,
                                    hir::Op::kAddI, assign.op_span, true);
  if (part.before.empty()) return stored;
  part.before.push_back(stored);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, assign.span, checker.seq(part.before));
}

}  // namespace

bool is_host_part(Checker& checker, const ast::Expr& target) {
  const ast::Expr* object = object_of(target);
  const Type* type = object == nullptr ? nullptr : type_of_place(checker, *object);
  return type != nullptr && type->is(Kind::kHost);
}

hir::Stmt* store_host_part(Checker& checker, const ast::Expr& target, hir::Expr* value,
                           const ast::AssignStmt& assign) {
  auto part = part_of(checker, target, assign.span);
  if (!part || value->type->is(Kind::kAny)) return nullptr;
  return store(checker, *part, target, value, assign);
}

hir::Stmt* change_host_part(Checker& checker, const ast::Expr& target,
                            const ast::AssignStmt& assign) {
  auto part = part_of(checker, target, assign.span);
  hir::Expr* value = checker.check_value(*assign.value);
  if (!part || value->type->is(Kind::kAny)) return nullptr;
  value = kept(checker, value, part->before);
  hir::Expr* old = call_native(checker, part->read, checker.registry.functions(part->read),
                               target.span, target.span, arguments(checker, *part, nullptr));
  if (old->type->is(Kind::kAny)) return nullptr;
  const bool is_sum = assign.op == ast::BinaryOp::kAdd || assign.op == ast::BinaryOp::kSub;
  if (old->type->is_double() && value->type->is_quantity() && is_sum) {
    // An element is a number in SI units. With a quantity on the right side it counts as a quantity
    // of the same dimension.
    old = checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, value->type, old->span,
                                         hir::Conversion::kSame, old);
  } else if (old->type->is_double() && !is_sum) {
    value = checker.require(value, {.type = checker.types.real()});
    if (value->type->is(Kind::kAny)) return nullptr;
  }
  const ast::BinaryExpr node = operation_of(assign, target);
  hir::Expr* result = combine(checker, node, old, value);
  if (result->type->is(Kind::kAny)) return nullptr;
  return store(checker, *part, target, result, assign);
}

// ---- reading -----------------------------------------------------------------------------------

namespace {

hir::Expr* call_row(Checker& checker, const std::string& name, Span span,
                    std::vector<Argument> arguments) {
  return call_native(checker, name, checker.registry.functions(name), span, span,
                     std::move(arguments));
}

// img[x0:x1, y0:y1], where every bound is optional.
hir::Expr* host_part(Checker& checker, const ast::IndexExpr& index, hir::Expr* object) {
  const std::string row = type_name(object->type) + "[:]";
  if (!has_row(checker, row, 2 * index.items.size())) return nullptr;
  const Signature& signature =
      checker.shared.signatures.of(*checker.registry.functions(row).front());
  std::vector<Argument> arguments = {Argument{.value = object}};
  std::size_t parameter = 1;
  for (const ast::IndexItem& item : index.items) {
    for (const ast::Expr* end : {item.first, item.last}) {
      const std::string_view name = signature.parameters[parameter++].name;
      if (end == nullptr) continue;
      arguments.push_back(
          Argument{.name = name, .name_span = end->span, .value = index_value(checker, *end, {})});
    }
  }
  return call_row(checker, row, index.span, std::move(arguments));
}

}  // namespace

hir::Expr* host_element(Checker& checker, const ast::IndexExpr& index, hir::Expr* object) {
  if (!object->type->is(Kind::kHost)) return nullptr;
  const auto ranges = static_cast<std::size_t>(
      std::ranges::count_if(index.items, [](const auto& item) { return item.is_range; }));
  if (ranges == index.items.size()) return host_part(checker, index, object);
  const std::string row =
      ranges == 0 ? element_row(checker, *object->type, kind_of(*object), index.items.size())
                  : std::string();
  if (row.empty()) return nullptr;
  std::vector<Argument> arguments = {Argument{.value = object}};
  for (const ast::IndexItem& item : index.items)
    arguments.push_back(Argument{.value = index_value(checker, *item.first, {})});
  return call_row(checker, row, index.span, std::move(arguments));
}

}  // namespace armlet::lang
