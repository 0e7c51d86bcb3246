#include "check/expressions/members.hpp"

#include <algorithm>
#include <cctype>

#include "check/calls/fields.hpp"
#include "check/calls/imported.hpp"
#include "check/calls/row_values.hpp"
#include "check/expressions/host_places.hpp"
#include "check/expressions/matrices.hpp"
#include "check/functions/function_names.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/indices.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {

namespace {

hir::Expr* check_type_member(Checker& checker, const ast::MemberExpr& member,
                             std::string_view name);

// The fix for a[i, j] of lists: a[i][j]
Fix bracket_for_each(const Checker& checker, const ast::IndexExpr& index) {
  Fix fix{.text = "write one pair of brackets for each index: a[i][j]"};
  std::string brackets;
  for (const ast::IndexItem& item : index.items) {
    if (item.is_range) return fix;
    brackets += '[' + checker.text_of(item.first->span) + ']';
  }
  const Span object = index.object->span;
  fix.text = "write " + checker.text_of(object) + brackets;
  fix.edits.push_back({{object.end, index.span.end, object.source}, brackets});
  return fix;
}

}  // namespace

hir::Expr* check_member(Checker& checker, const ast::MemberExpr& member, const Type* expected) {
  if (hir::Expr* value = named_row_value(checker, member)) return value;
  const std::string name = dotted_name(checker, *member.object);
  if (const Import* from = checker.names.find_import(name))
    return imported_member(checker, *from, member, expected);
  if (const std::string function = library_function(checker, member); !function.empty()) {
    if (hir::Expr* value = library_function_value(checker, member, function, expected))
      return value;
  }
  if (!name.empty()) {
    if (hir::Expr* value = check_type_member(checker, member, name)) return value;
  }
  hir::Expr* object = checker.check_value(*member.object);
  if (object->type->is(Kind::kAny)) return checker.failed(member.span);
  return field_of(checker, object, member);
}

namespace {

// State.Idle, State.values, Math.PI, motors.something; null if `name` has no such members.
hir::Expr* check_type_member(Checker& checker, const ast::MemberExpr& member,
                             std::string_view name) {
  const std::string_view field = member.member.text;
  if (const Type* type = declared_type(checker, name); type != nullptr && type->is(Kind::kEnum)) {
    note_type_use(checker, *type, member.object->span);
    const EnumInfo& info = *type->enumeration;
    const auto value = [&](std::int64_t i) {
      return checker.make<hir::IntExpr>(hir::ExprKind::kEnum, type, member.span, i);
    };
    if (const int i = checker.shared.structs.value_index(info, field); i >= 0) {
      if (checker.shared.learnt != nullptr) {
        checker.shared.learnt->use(
            member.member.span, checker.shared.learnt->value_of(info, static_cast<std::size_t>(i)));
      }
      return value(i);
    }
    if (field == "values") return enum_values(checker, type, member.span);
    Diagnostic diagnostic =
        make_diagnostic("E0218", member.member.span, {std::string(name), std::string(field)});
    if (checker.messages.takes_errors()) {
      diagnostic.fix = did_you_mean(checker, field, member.member.span,
                                    {info.values.begin(), info.values.end()});
    }
    checker.report(std::move(diagnostic));
    return checker.failed(member.span);
  }
  const std::string full = std::string(name) + '.' + std::string(field);
  const NativeConstant* constant = checker.registry.constant(full);
  if (constant == nullptr && name == "Math") constant = checker.registry.constant(field);
  if (constant != nullptr) {
    return checker.make<hir::RealExpr>(hir::ExprKind::kReal, checker.types.quantity(constant->dim),
                                       member.span, constant->value);
  }
  if (!checker.registry.is_namespace(name) && name != "Math") return nullptr;
  return unknown_name(checker, full, member.span);
}

}  // namespace

namespace {}  // namespace

namespace {}  // namespace

hir::Expr* check_index(Checker& checker, const ast::IndexExpr& index) {
  hir::Expr* object = checker.check_value(*index.object);
  const Type* type = object->type;
  if (type->is(Kind::kAny)) return checker.failed(index.span);
  if (type->is(Kind::kMatrix)) return check_matrix_index(checker, index, object);
  if (hir::Expr* part = host_element(checker, index, object)) return part;
  if (index.items.size() > 1) {
    Diagnostic diagnostic =
        make_diagnostic("E0318", index.span, {"with a comma, " + type_phrase(type)});
    if (type->is(Kind::kList)) diagnostic.fix = bracket_for_each(checker, index);
    checker.report(std::move(diagnostic));
    return checker.failed(index.span);
  }
  const ast::IndexItem& item = index.items[0];
  if (type->is(Kind::kMap)) return entry_of(checker, index, object);
  const bool is_text = type->is(Kind::kText);
  if (type->is(Kind::kList) || is_text) {
    const Indexed of{.object = index.object->span};
    if (item.is_range) {
      hir::Expr* first = item.first != nullptr ? index_value(checker, *item.first, of) : nullptr;
      hir::Expr* last = item.last != nullptr ? index_value(checker, *item.last, of) : nullptr;
      return checker.make<hir::SliceExpr>(hir::ExprKind::kSlice, type, index.span, object, first,
                                          last);
    }
    hir::Expr* place = index_value(checker, *item.first, of);
    if (is_text)
      return checker.make<hir::CharacterExpr>(hir::ExprKind::kCharacter, type, index.span, object,
                                              place);
    return checker.make<hir::ElementExpr>(hir::ExprKind::kElement, type->element, index.span,
                                          object, place);
  }
  checker.report(make_diagnostic("E0318", index.object->span, {type_phrase(type)}));
  return checker.failed(index.span);
}

}  // namespace armlet::lang
