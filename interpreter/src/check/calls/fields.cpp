#include "check/calls/fields.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "check/calls/intrinsics.hpp"
#include "check/calls/tables.hpp"
#include "check/explain/listed_names.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/learnt.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {
namespace {

// Whether an expression can be evaluated twice: it has the same value and costs little.
bool is_path(const hir::Expr& expr) {
  using hir::ExprKind;
  if (expr.kind == ExprKind::kField) return is_path(*expr.as<hir::FieldExpr>().object);
  if (expr.kind == ExprKind::kElement)
    return is_path(*expr.as<hir::ElementExpr>().object) &&
           is_path(*expr.as<hir::ElementExpr>().index);
  return expr.kind == ExprKind::kVariable || expr.kind == ExprKind::kInt;
}

hir::Expr* last_of(Checker& checker, hir::Expr* list, Span span) {
  const Type* element = list->type->element;
  if (!is_path(*list)) return last_call(checker, list, span);
  hir::Expr* length =
      checker.make<hir::LengthExpr>(hir::ExprKind::kLength, checker.types.integer(), span, list);
  hir::Expr* one = checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(), span,
                                              std::int64_t{1});
  hir::Expr* index = checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, checker.types.integer(),
                                                   span, hir::Op::kSubI, length, one, span);
  return checker.make<hir::ElementExpr>(hir::ExprKind::kElement, element, span, list, index);
}

// Whether a library function is a field: neither a row of a block, whose name has another point,
// nor a method with arguments.
bool is_field(Checker& checker, std::string_view name) {
  return std::ranges::count(name, '.') == 1 &&
         std::ranges::any_of(checker.registry.functions(name), [&](const NativeFunction* function) {
           return checker.shared.signatures.of(*function).parameters.size() == 1;
         });
}

}  // namespace

void note_field_use(Checker& checker, const Type& record, std::size_t field, Span name) {
  if (checker.shared.learnt == nullptr) return;
  const StructDecl* declared = checker.shared.structs.find(&record);
  if (declared != nullptr && field < declared->node->fields.size())
    checker.shared.learnt->use(name, declared->node->fields[field].name.span);
}

hir::Expr* unknown_field(Checker& checker, const hir::Expr& object, const ast::Name& field) {
  // A call may be incomplete.
  if (const FunctionDecl* function = checker.names.find_function(field.text);
      checker.shared.guesses && function != nullptr)
    checker.shared.learnt->use(field.span, function->node->name.span);
  // A struct with mistakes may have a field with this name.
  if (checker.messages.syntax_failed() || checker.messages.was_told(field.text))
    return checker.failed(field.span);
  std::vector<std::string> names;
  const Type* type = object.type;
  if (!checker.messages.takes_errors()) {
    checker.report(make_diagnostic("E0208", field.span, {"", ""}));
    return checker.failed(field.span);
  }
  if (type->is(Kind::kRecord)) {
    for (const RecordField& known : type->record->fields) names.push_back(known.name);
    if (type->is_table()) names.emplace_back("length");
  } else if (type->is(Kind::kHost) || type->is(Kind::kMatrix)) {
    const std::string prefix = type_name(type) + '.';
    for (const std::string_view known : checker.registry.public_names()) {
      if (known.starts_with(prefix) && is_field(checker, known))
        names.emplace_back(known.substr(prefix.size()));
    }
  } else if (type->is(Kind::kList)) {
    names = {"length", "last"};
  } else if (type->is(Kind::kText) || type->is(Kind::kMap)) {
    names = {"length"};
  } else if (type->is(Kind::kEnum)) {
    names = {"name"};
  }
  Diagnostic diagnostic =
      make_diagnostic("E0208", field.span, {type_phrase(type), std::string(field.text)});
  if (!names.empty()) diagnostic.why = "its fields are " + listed_names(field.text, names);
  if (names.size() == 1) diagnostic.why = "its only field is " + names[0];
  if (std::optional<Fix> meant;
      type->is(Kind::kMap) && (meant = fix_of_map_member(checker, type, field))) {
    diagnostic.fix = std::move(meant);
  } else if (checker.names.find_function(field.text) != nullptr ||
             !checker.registry.functions(field.text).empty()) {
    const std::string call = std::string(field.text) + "()";
    diagnostic.fix = Fix{.text = "write " + call, .edits = {{field.span, call}}};
  } else {
    diagnostic.fix = did_you_mean(checker, field.text, field.span, {names.begin(), names.end()});
  }
  checker.report(std::move(diagnostic));
  return checker.failed(field.span);
}

hir::Expr* field_of(Checker& checker, hir::Expr* object, const ast::MemberExpr& member) {
  const std::string_view field = member.member.text;
  const Type* type = object->type;
  const bool has_length = type->is(Kind::kList) || type->is(Kind::kText) || type->is(Kind::kMap);
  if (has_length && field == "length") {
    return checker.make<hir::LengthExpr>(hir::ExprKind::kLength, checker.types.integer(),
                                         member.span, object);
  }
  if (type->is(Kind::kList) && field == "last") return last_of(checker, object, member.span);
  if (type->is(Kind::kEnum) && field == "name") return enum_name(checker, object, member.span);
  if (type->is_table()) return column_of(checker, object, member);
  if (type->is(Kind::kRecord)) {
    const int i = checker.shared.structs.field_index(*type->record, field);
    if (i < 0) return unknown_field(checker, *object, member.member);
    note_field_use(checker, *type, static_cast<std::size_t>(i), member.member.span);
    return checker.make<hir::FieldExpr>(hir::ExprKind::kField, type->record->fields[i].type,
                                        member.span, object, static_cast<std::uint32_t>(i));
  }
  const std::string native = type_name(type) + '.' + std::string(field);
  if (const auto found = checker.registry.functions(native); !found.empty()) {
    return call_native(checker, native, found, member.member.span, member.span,
                       {Argument{.value = object}});
  }
  return unknown_field(checker, *object, member.member);
}

}  // namespace armlet::lang
