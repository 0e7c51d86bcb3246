#include "check/types/members.hpp"

#include <algorithm>
#include <cctype>

#include "check/blocks/named_rows.hpp"
#include "check/calls/intrinsics.hpp"
#include "check/calls/native_calls.hpp"
#include "check/explain/listed_names.hpp"
#include "check/names/function_names.hpp"
#include "check/names/host_places.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/statements/recordings.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"
#include "check/types/matrices.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

namespace {

hir::Expr* check_type_member(Checker& checker, const ast::MemberExpr& member,
                             std::string_view name);
hir::Expr* last_of(Checker& checker, hir::Expr* list, Span span);

// Whether an expression can be evaluated twice: it has the same value and costs little.
bool is_path(const hir::Expr& expr) {
  using hir::ExprKind;
  if (expr.kind == ExprKind::kField) return is_path(*expr.as<hir::FieldExpr>().object);
  if (expr.kind == ExprKind::kElement)
    return is_path(*expr.as<hir::ElementExpr>().object) &&
           is_path(*expr.as<hir::ElementExpr>().index);
  return expr.kind == ExprKind::kVariable || expr.kind == ExprKind::kInt;
}

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

std::string dotted_name(Checker& checker, const ast::Expr& expr) {
  if (expr.kind == ast::ExprKind::kName) {
    const std::string_view name = expr.as<ast::NameExpr>().name;
    FunctionContext* where = nullptr;
    return checker.scopes.find(name, where) == nullptr ? std::string(name) : std::string();
  }
  if (expr.kind != ast::ExprKind::kMember) return {};
  const auto& member = expr.as<ast::MemberExpr>();
  const std::string object = dotted_name(checker, *member.object);
  return object.empty() ? object : object + '.' + std::string(member.member.text);
}

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

void note_field_use(Checker& checker, const Type& record, std::size_t field, Span name) {
  if (checker.shared.learnt == nullptr) return;
  const StructDecl* declared = checker.shared.structs.find(&record);
  if (declared != nullptr && field < declared->node->fields.size())
    checker.shared.learnt->use(name, declared->node->fields[field].name.span);
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

namespace {

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

namespace {

// Whether the text is a name, or names joined by points, which can be evaluated twice.
bool is_written_path(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return c == '.' || c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
}

// Whether an index is a number in the text or computed from such numbers. The value of a variable
// may be tested before: `let best = -1; if (best >= 0) print(xs[best])`.
bool is_literal(const hir::Expr& expr) {
  if (expr.kind == hir::ExprKind::kUnary) return is_literal(*expr.as<hir::UnaryExpr>().operand);
  if (expr.kind == hir::ExprKind::kBinary) {
    const auto& node = expr.as<hir::BinaryExpr>();
    return is_literal(*node.left) && is_literal(*node.right);
  }
  return expr.kind == hir::ExprKind::kInt && !expr.type->is(Kind::kAny);
}

void refuse_below_zero(Checker& checker, const ast::Expr& written, std::int64_t value,
                       const Indexed& of) {
  Diagnostic diagnostic = make_diagnostic("E0340", written.span, {std::to_string(value)});
  const std::string object = checker.text_of(of.object);
  if (is_written_path(object)) {
    const std::string from_end = std::to_string(value).substr(1);  // without its sign
    const std::string meant = object + '.' + std::string(of.size) + " - " + from_end;
    diagnostic.fix = Fix{.text = "counted from the end it is " + meant,
                         .edits = {{written.span, meant}},
                         .confidence = Confidence::kMaybe};
  } else {
    diagnostic.fix = Fix{.text = "count from the end with ." + std::string(of.size)};
  }
  checker.report(std::move(diagnostic));
}

}  // namespace

hir::Expr* index_value(Checker& checker, const ast::Expr& expr, const Indexed& of) {
  hir::Expr* value = checker.check_as(expr, {.type = checker.types.integer(), .name = "index"});
  if (of.object.empty() || !is_literal(*value)) return value;
  const auto constant = checker.shared.constants.of(*value);
  if (constant && constant->kind == Constant::Kind::kInt && constant->integer < 0)
    refuse_below_zero(checker, expr, constant->integer, of);
  return value;
}

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
