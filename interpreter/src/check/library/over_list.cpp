// Checks map, filter, fold and similar functions of the library. The library declares them without
// C++ code; they are compiled to loops, so that the functions given to them may fail, wait or be
// stopped like others.

#include "check/library/over_list.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace armlet::lang {
namespace {

using hir::ListVerb;

constexpr std::array<std::pair<std::string_view, ListVerb>, 9> kVerbs = {
    {{"map", ListVerb::kMap},
     {"filter", ListVerb::kFilter},
     {"fold", ListVerb::kFold},
     {"any", ListVerb::kAny},
     {"all", ListVerb::kAll},
     {"sort", ListVerb::kSort},
     {"zip", ListVerb::kZip},
     {"contains", ListVerb::kContains},
     {"indexOf", ListVerb::kIndexOf}}};

// The loop that a function is compiled to; empty for functions that the library implements.
std::optional<ListVerb> verb_of(const NativeFunction& function) {
  if (function.thunk) return std::nullopt;
  for (const auto& [name, verb] : kVerbs) {
    if (name == function.name) return verb;
  }
  return std::nullopt;
}

bool is_key(const Type* type) { return type->is_number() || type->is(Kind::kText); }

}  // namespace

void settle_start(Checker& checker, std::span<const NativeFunction* const> candidates,
                  std::vector<Argument>& arguments) {
  const bool is_fold = verb_of(*candidates.front()) == ListVerb::kFold;
  if (!is_fold || arguments.size() < 2 || arguments[0].waits() || arguments[1].waits()) return;
  const Type* list = arguments[0].value->type;
  hir::Expr*& start = arguments[1].value;
  const bool written = start->kind == hir::ExprKind::kInt || is_zero(*start);
  if (!written || !list->is(Kind::kList) || !list->element->is(Kind::kReal)) return;
  if (is_zero(*start) || list->element->is_double()) {
    const double value = checker.shared.constants.of(*start)->real;
    start = checker.make<hir::RealExpr>(hir::ExprKind::kReal, list->element, start->span, value);
  }
}

hir::Expr* over_list(Checker& checker, const NativeFunction& function, hir::CallNativeExpr& call) {
  const std::optional<ListVerb> verb = verb_of(function);
  if (!verb) return nullptr;
  const auto refuse = [&](const hir::Expr& value, std::string need, const Type* type) {
    checker.report(make_diagnostic(
        "E0313", value.span, {std::string(function.name), std::move(need), type_phrase(type)}));
    return checker.failed(call.span);
  };
  for (const hir::Expr* value : call.arguments) {
    if (value->type->is(Kind::kAny)) return checker.failed(call.span);
  }
  if (*verb == ListVerb::kSort && !is_key(call.arguments[1]->type->result))
    return refuse(*call.arguments[1], "a function that gives a number or a text",
                  call.arguments[1]->type->result);
  const hir::Expr* last = call.arguments.back();
  const bool searches = *verb == ListVerb::kContains || *verb == ListVerb::kIndexOf;
  if (searches && !has_deep_equality(last->type))
    return refuse(*last, "a value that == can compare", last->type);
  return checker.make<hir::OverListExpr>(hir::ExprKind::kOverList, call.type, call.span, *verb,
                                         call.arguments, call.site);
}

// The word of a named row: "phase" for "motor.phase.NAME".
static std::string_view written_name(const NativeFunction& function) {
  std::string_view name = function.name;
  if (!name.ends_with(kNamedRow)) return name;
  name.remove_suffix(kNamedRow.size());
  return name.substr(name.rfind('.') + 1);
}

void note_callbacks(Checker& checker, const NativeFunction& function,
                    const std::vector<hir::Expr*>& values) {
  for (const hir::Expr* value : values) {
    const hir::Function* given = nullptr;
    if (value->kind == hir::ExprKind::kFunctionValue)
      given = value->as<hir::FunctionValueExpr>().function;
    if (value->kind == hir::ExprKind::kClosure) given = value->as<hir::ClosureExpr>().function;
    if (given != nullptr)
      checker.shared.postponed.add(Postponed::Callback{written_name(function), given, value->span,
                                                       function.name.ends_with(kNamedRow)});
  }
}

}  // namespace armlet::lang
