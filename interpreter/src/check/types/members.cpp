// x.name and x[i].

#include <algorithm>

#include "check/checker.hpp"
#include "check/names/function_names.hpp"
#include "check/names/imports.hpp"
#include "check/statements/recordings.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"
#include "check/types/matrices.hpp"

namespace armlet::lang {
namespace {

// Evaluating it twice gives the same value and costs little.
bool is_path(const hir::Expr& expr) {
  switch (expr.kind) {
    case hir::ExprKind::kVariable:
    case hir::ExprKind::kInt:
      return true;
    case hir::ExprKind::kField:
      return is_path(*expr.as<hir::FieldExpr>().object);
    case hir::ExprKind::kElement:
      return is_path(*expr.as<hir::ElementExpr>().object) &&
             is_path(*expr.as<hir::ElementExpr>().index);
    default:
      return false;
  }
}

// a[i, j] of lists: a[i][j]
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

std::string Checker::dotted_name(const ast::Expr& expr) {
  if (expr.kind == ast::ExprKind::kName) {
    const std::string_view name = expr.as<ast::NameExpr>().name;
    FunctionContext* where = nullptr;
    return find_local(name, where) == nullptr ? std::string(name) : std::string();
  }
  if (expr.kind != ast::ExprKind::kMember) return {};
  const auto& member = expr.as<ast::MemberExpr>();
  const std::string object = dotted_name(*member.object);
  return object.empty() ? object : object + '.' + std::string(member.member.text);
}

hir::Expr* Checker::check_member(const ast::MemberExpr& member, const Type* expected) {
  const std::string name = dotted_name(*member.object);
  if (const Import* from = find_import(*this, name))
    return imported_member(*this, *from, member, expected);
  if (const std::string function = library_function(*this, member); !function.empty()) {
    if (hir::Expr* value = library_function_value(*this, member, function, expected)) return value;
  }
  if (!name.empty()) {
    if (hir::Expr* value = check_type_member(member, name)) return value;
  }
  hir::Expr* object = check_value(*member.object);
  if (object->type->is(Kind::kAny)) return failed(member.span);
  return field_of(object, member);
}

// State.Idle, State.values, Math.PI, motors.something; null if `name` is none of these.
hir::Expr* Checker::check_type_member(const ast::MemberExpr& member, std::string_view name) {
  const std::string_view field = member.member.text;
  if (const Type* type = declared_type(*this, name); type != nullptr && type->is(Kind::kEnum)) {
    const EnumInfo& info = *type->enumeration;
    const auto value = [&](std::int64_t i) {
      return make<hir::IntExpr>(hir::ExprKind::kEnum, type, member.span, i);
    };
    if (const int i = value_index(*this, info, field); i >= 0) return value(i);
    if (field == "values") return enum_values(*this, type, member.span);
    Diagnostic diagnostic =
        make_diagnostic("E0218", member.member.span, {std::string(name), std::string(field)});
    if (takes_errors()) {
      diagnostic.fix =
          did_you_mean(field, member.member.span, {info.values.begin(), info.values.end()});
    }
    report(std::move(diagnostic));
    return failed(member.span);
  }
  const std::string full = std::string(name) + '.' + std::string(field);
  const NativeConstant* constant = registry_.constant(full);
  if (constant == nullptr && name == "Math") constant = registry_.constant(field);
  if (constant != nullptr) {
    return make<hir::RealExpr>(hir::ExprKind::kReal, types_.quantity(constant->dim), member.span,
                               constant->value);
  }
  if (!registry_.is_namespace(name) && name != "Math") return nullptr;
  return unknown_name(full, member.span);
}

hir::Expr* Checker::field_of(hir::Expr* object, const ast::MemberExpr& member) {
  const std::string_view field = member.member.text;
  const Type* type = object->type;
  const bool has_length = type->is(Kind::kList) || type->is(Kind::kText) || type->is(Kind::kMap);
  if (has_length && field == "length") {
    return make<hir::LengthExpr>(hir::ExprKind::kLength, types_.integer(), member.span, object);
  }
  if (type->is(Kind::kList) && field == "last") return last_of(object, member.span);
  if (type->is(Kind::kEnum) && field == "name") return enum_name(object, member.span);
  if (type->is_table()) return column_of(*this, object, member);
  if (type->is(Kind::kRecord)) {
    const int i = field_index(*this, *type->record, field);
    if (i < 0) return unknown_field(*object, member.member);
    return make<hir::FieldExpr>(hir::ExprKind::kField, type->record->fields[i].type, member.span,
                                object, static_cast<std::uint32_t>(i));
  }
  const std::string native = type_name(type) + '.' + std::string(field);
  if (const auto found = registry_.functions(native); !found.empty()) {
    return call_native(native, found, member.member.span, member.span, {Argument{.value = object}});
  }
  return unknown_field(*object, member.member);
}

hir::Expr* Checker::last_of(hir::Expr* list, Span span) {
  const Type* element = list->type->element;
  if (!is_path(*list)) return last_call(list, span);
  hir::Expr* length = make<hir::LengthExpr>(hir::ExprKind::kLength, types_.integer(), span, list);
  hir::Expr* one = make<hir::IntExpr>(hir::ExprKind::kInt, types_.integer(), span, std::int64_t{1});
  hir::Expr* index = make<hir::BinaryExpr>(hir::ExprKind::kBinary, types_.integer(), span,
                                           hir::Op::kSubI, length, one, span);
  return make<hir::ElementExpr>(hir::ExprKind::kElement, element, span, list, index);
}

hir::Expr* Checker::unknown_field(const hir::Expr& object, const ast::Name& field) {
  // A field may have this name in a struct whose text failed.
  if (syntax_failed_ || told_.contains(field.text)) return failed(field.span);
  std::vector<std::string> names;
  const Type* type = object.type;
  if (!takes_errors()) {
    report(make_diagnostic("E0208", field.span, {"", ""}));
    return failed(field.span);
  }
  if (type->is(Kind::kRecord)) {
    for (const RecordField& known : type->record->fields) names.push_back(known.name);
    if (type->is_table()) names.emplace_back("length");
  } else if (type->is(Kind::kHost) || type->is(Kind::kMatrix)) {
    const std::string prefix = type_name(type) + '.';
    for (const std::string_view known : registry_.public_names()) {
      if (known.starts_with(prefix)) names.emplace_back(known.substr(prefix.size()));
    }
  } else if (type->is(Kind::kList)) {
    names = {"length", "last"};
  } else if (type->is(Kind::kText) || type->is(Kind::kMap)) {
    names = {"length"};
  } else if (type->is(Kind::kEnum)) {
    names = {"name"};
  }
  const std::string whole = type_name(type) + '.' + std::string(field.text);
  if (registry_.is_planned(whole)) return not_available(field.span, '`' + whole + '`');
  Diagnostic diagnostic =
      make_diagnostic("E0208", field.span, {type_phrase(type), std::string(field.text)});
  for (std::size_t i = 0; i < names.size(); ++i) {
    diagnostic.why += (i == 0                 ? "its fields are "
                       : i + 1 < names.size() ? ", "
                                              : " and ") +
                      names[i];
  }
  if (names.size() == 1) diagnostic.why = "its only field is " + names[0];
  if (std::optional<Fix> meant;
      type->is(Kind::kMap) && (meant = fix_of_map_member(*this, type, field))) {
    diagnostic.fix = std::move(meant);
  } else if (find_function(field.text) != nullptr || !registry_.functions(field.text).empty()) {
    const std::string call = std::string(field.text) + "()";
    diagnostic.fix = Fix{.text = "write " + call, .edits = {{field.span, call}}};
  } else {
    diagnostic.fix = did_you_mean(field.text, field.span, {names.begin(), names.end()});
  }
  report(std::move(diagnostic));
  return failed(field.span);
}

hir::Expr* Checker::index_value(const ast::Expr& expr) {
  return check_as(expr, {.type = types_.integer(), .name = "index"});
}

hir::Expr* Checker::check_index(const ast::IndexExpr& index) {
  hir::Expr* object = check_value(*index.object);
  const Type* type = object->type;
  if (type->is(Kind::kAny)) return failed(index.span);
  if (type->is(Kind::kMatrix)) return check_matrix_index(*this, index, object);
  if (index.items.size() > 1) {
    Diagnostic diagnostic =
        make_diagnostic("E0318", index.span, {"with a comma, " + type_phrase(type)});
    if (type->is(Kind::kList)) diagnostic.fix = bracket_for_each(*this, index);
    report(std::move(diagnostic));
    return failed(index.span);
  }
  const ast::IndexItem& item = index.items[0];
  if (type->is(Kind::kMap)) return entry_of(*this, index, object);
  const bool is_text = type->is(Kind::kText);
  if (type->is(Kind::kList) || is_text) {
    if (item.is_range) {
      hir::Expr* first = item.first != nullptr ? index_value(*item.first) : nullptr;
      hir::Expr* last = item.last != nullptr ? index_value(*item.last) : nullptr;
      return make<hir::SliceExpr>(hir::ExprKind::kSlice, type, index.span, object, first, last);
    }
    hir::Expr* place = index_value(*item.first);
    if (is_text)
      return make<hir::CharacterExpr>(hir::ExprKind::kCharacter, type, index.span, object, place);
    return make<hir::ElementExpr>(hir::ExprKind::kElement, type->element, index.span, object,
                                  place);
  }
  const std::string native = type_name(type) + "[]";
  if (const auto found = registry_.functions(native); !found.empty() && !item.is_range) {
    return call_native(native, found, index.span, index.span,
                       {Argument{.value = object}, Argument{.value = index_value(*item.first)}});
  }
  report(make_diagnostic("E0318", index.object->span, {type_phrase(type)}));
  return failed(index.span);
}

}  // namespace armlet::lang
