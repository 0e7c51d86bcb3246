// Large structs and enums: names are found in a table, and code that would be long at every use
// becomes a function.

#include "check/types/long_lists.hpp"

#include <algorithm>

#include "check/names/variables.hpp"

namespace armlet::lang {
namespace {

constexpr std::size_t kMany = 16;  // with this many names a function is better

hir::Expr* list_of_names(Checker& checker, const EnumInfo& info, Span span) {
  std::vector<hir::Expr*> names;
  const Type* text = checker.types.text();
  for (const std::string& name : info.values) {
    names.push_back(
        checker.make<hir::TextExpr>(hir::ExprKind::kText, text, span, checker.arena.copy(name)));
  }
  return checker.make<hir::ListExpr>(hir::ExprKind::kList, checker.types.list(text), span,
                                     checker.seq(names));
}

hir::Expr* list_of_values(Checker& checker, const Type* type, Span span) {
  std::vector<hir::Expr*> all;
  for (std::size_t i = 0; i < type->enumeration->values.size(); ++i) {
    all.push_back(
        checker.make<hir::IntExpr>(hir::ExprKind::kEnum, type, span, static_cast<std::int64_t>(i)));
  }
  return checker.make<hir::ListExpr>(hir::ExprKind::kList, checker.types.list(type), span,
                                     checker.seq(all));
}

hir::Expr* name_at(Checker& checker, hir::Expr* names, hir::Expr* value, Span span) {
  hir::Expr* number = checker.make<hir::ConvertExpr>(
      hir::ExprKind::kConvert, checker.types.integer(), span, hir::Conversion::kSame, value);
  return checker.make<hir::ElementExpr>(hir::ExprKind::kElement, checker.types.text(), span, names,
                                        number);
}

void give_body(Checker& checker, hir::Function& function, hir::Expr* result) {
  hir::Stmt* give = checker.make<hir::ReturnStmt>(hir::StmtKind::kReturn, function.span, result);
  function.result = result->type;
  function.body = checker.make<hir::Block>(hir::StmtKind::kBlock, function.span,
                                           checker.seq(std::vector<hir::Stmt*>{give}));
}

hir::Expr* call_of(Checker& checker, hir::Function* function, const std::vector<hir::Expr*>& values,
                   Span span) {
  std::vector<Span> spans;
  for (const hir::Expr* value : values) spans.push_back(value->span);
  checker.scopes.use().add(function);
  return checker.make<hir::CallExpr>(hir::ExprKind::kCall, function->result, span, function,
                                     checker.seq(values),
                                     hir::CallSite{span, span, checker.seq(spans)});
}

}  // namespace

// The name of an enum value, from a list of the names.
hir::Expr* enum_name(Checker& checker, hir::Expr* value, Span span) {
  const EnumInfo& info = *value->type->enumeration;
  if (info.values.size() < kMany)
    return name_at(checker, list_of_names(checker, info, span), value, span);
  hir::Function*& known = checker.shared.structs.name_function(info);
  if (known == nullptr) {
    known = checker.shared.instances.make_function(info.name + ".name", span);
    hir::Variable* parameter = hidden(checker, value->type, span);
    parameter->owner = known;
    parameter->is_parameter = true;
    known->parameters = checker.seq(std::vector<hir::Variable*>{parameter});
    hir::Expr* read =
        checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, value->type, span, parameter);
    give_body(checker, *known, name_at(checker, list_of_names(checker, info, span), read, span));
  }
  return call_of(checker, known, {value}, span);
}

hir::Expr* enum_values(Checker& checker, const Type* type, Span span) {
  if (type->enumeration->values.size() < kMany) return list_of_values(checker, type, span);
  hir::Function*& known = checker.shared.structs.values_function(*type->enumeration);
  if (known == nullptr) {
    known = checker.shared.instances.make_function(type->enumeration->name + ".values", span);
    known->gives_fixed_value = true;
    give_body(checker, *known, list_of_values(checker, type, span));
  }
  return call_of(checker, known, {}, span);
}

// ---- default values

namespace {

constexpr int kFewParts = 24;  // parts of a default value that each call may repeat
constexpr std::size_t kShortText = 64;
constexpr std::size_t kMostDefaults = 1'000'000;

struct Parts {
  const NativeFunction* filled;  // LanguageFunctions::filled
  int count = 0;
};

bool all_fixed(const auto& items, Parts& parts);

// Whether a value is the same at every call: a literal, or a host value or a new list made from
// such values. Counts its parts.
bool is_fixed_value(const hir::Expr& value, Parts& parts) {
  const bool is_text = value.kind == hir::ExprKind::kText;
  parts.count += is_text && value.as<hir::TextExpr>().value.size() > kShortText ? 1 + kFewParts : 1;
  switch (value.kind) {
    case hir::ExprKind::kText:
    case hir::ExprKind::kBool:
    case hir::ExprKind::kInt:
    case hir::ExprKind::kReal:
    case hir::ExprKind::kEnum:
    case hir::ExprKind::kAbsent:
    case hir::ExprKind::kFunctionValue:
      return true;
    case hir::ExprKind::kConvert:
      return is_fixed_value(*value.as<hir::ConvertExpr>().operand, parts);
    case hir::ExprKind::kUnary:
      return is_fixed_value(*value.as<hir::UnaryExpr>().operand, parts);
    case hir::ExprKind::kBinary:
      return is_fixed_value(*value.as<hir::BinaryExpr>().left, parts) &&
             is_fixed_value(*value.as<hir::BinaryExpr>().right, parts);
    case hir::ExprKind::kList:
      return all_fixed(value.as<hir::ListExpr>().items, parts);
    case hir::ExprKind::kMap:
      return all_fixed(value.as<hir::MapExpr>().keys, parts) &&
             all_fixed(value.as<hir::MapExpr>().values, parts);
    case hir::ExprKind::kMatrix:
      return all_fixed(value.as<hir::MatrixExpr>().items, parts);
    case hir::ExprKind::kRecord:
      return all_fixed(value.as<hir::RecordExpr>().fields, parts);
    case hir::ExprKind::kNewArray:
      return all_fixed(value.as<hir::NewArrayExpr>().sizes, parts);
    case hir::ExprKind::kCallNative:
      return (value.type->is(Kind::kHost) ||
              value.as<hir::CallNativeExpr>().function == parts.filled) &&
             all_fixed(value.as<hir::CallNativeExpr>().arguments, parts);
    case hir::ExprKind::kCall:  // of a function that returns a default value
      return value.as<hir::CallExpr>().function->gives_fixed_value;
    case hir::ExprKind::kVariable:
    case hir::ExprKind::kAnd:
    case hir::ExprKind::kOr:
    case hir::ExprKind::kCond:
    case hir::ExprKind::kField:
    case hir::ExprKind::kElement:
    case hir::ExprKind::kSlice:
    case hir::ExprKind::kLength:
    case hir::ExprKind::kCharacter:
    case hir::ExprKind::kCallValue:
    case hir::ExprKind::kClosure:
    case hir::ExprKind::kConcat:
    case hir::ExprKind::kToText:
    case hir::ExprKind::kError:
    case hir::ExprKind::kMutate:
    case hir::ExprKind::kGuarded:
    case hir::ExprKind::kPart:
    case hir::ExprKind::kOverList:
    case hir::ExprKind::kEntry:
    case hir::ExprKind::kMapQuery:
      break;
  }
  return false;
}

bool all_fixed(const auto& items, Parts& parts) {
  return std::ranges::all_of(
      items, [&parts](const hir::Expr* item) { return is_fixed_value(*item, parts); });
}

// Checks a default value at its first use. If every use repeated the defaults of nested structs,
// the code would grow without limit, so large defaults become functions.
Default& known_default(Checker& checker, const ast::Expr& expr, const Target& target) {
  const auto [entry, is_new] = checker.shared.defaults.find(expr);
  Default& known = *entry;
  if (known.is_open) {  // a struct whose default contains itself
    checker.report(make_diagnostic("E0125", expr.span, {"600 levels"}));
    known.value = checker.failed(expr.span);
  }
  if (!is_new) return known;
  known.value = checker.failed(expr.span);
  known.is_open = true;
  const bool before = checker.scopes.see_top_level_only(true);
  Use used;
  Use& use_before = checker.scopes.collect_in(used);
  hir::Expr* value =
      target.type != nullptr ? checker.check_as(expr, target) : checker.check_value(expr);
  checker.scopes.collect_in(use_before);
  checker.scopes.see_top_level_only(before);
  known.is_open = false;
  known.use = std::move(used);
  if (value->type->is(Kind::kAny)) return known;
  Parts parts{checker.registry.language().filled};
  if (!is_fixed_value(*value, parts)) {
    checker.report(
        make_diagnostic("E0334", expr.span, {"a default", "a value written in the text"}));
    return known;
  }
  known.value = value;
  if (parts.count <= kFewParts) return known;
  known.function =
      checker.shared.instances.make_function("default of " + std::string(target.name), expr.span);
  known.function->gives_fixed_value = true;
  checker.shared.uses.of(known.function) = std::exchange(known.use, {});
  give_body(checker, *known.function, value);
  return known;
}

}  // namespace

hir::Expr* default_value(Checker& checker, Checker& file, const ast::Expr& expr,
                         const Target& target) {
  if (const std::size_t taken = checker.shared.defaults.take(); taken > kMostDefaults) {
    if (taken == kMostDefaults + 1)
      checker.report(make_diagnostic(
          "E0124", target.call,
          {"more than " + std::to_string(kMostDefaults) + " values left out in calls"}));
    return checker.failed(target.call);
  }
  Default& known = known_default(file, expr, target);
  checker.scopes.use().add(known.use);
  if (known.function == nullptr) return known.value;
  hir::Expr* value = call_of(checker, known.function, {}, target.call);
  value->fact = known.value->fact;
  return value;
}

}  // namespace armlet::lang
