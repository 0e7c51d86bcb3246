// Functions of the library that visit every element of a list: map, filter, fold ... The library
// declares them without a thunk; the program runs them as loops, so that the function they are
// given may fail, wait or be stopped like any other.

#include <array>
#include <optional>
#include <utility>

#include "check/checker.hpp"

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

// What a function does as a loop; nothing for those that the library runs.
std::optional<ListVerb> verb_of(const NativeFunction& function) {
  if (function.thunk != nullptr || function.later) return std::nullopt;
  for (const auto& [name, verb] : kVerbs) {
    if (name == function.name) return verb;
  }
  return std::nullopt;
}

bool is_key(const Type* type) { return type->is_number() || type->is(Kind::kText); }

}  // namespace

// fold(xs, 0, f): a whole number written as the start becomes what the elements are, because what f
// gives does. 0 becomes any quantity, other numbers a double.
void Checker::settle_start(std::span<const NativeFunction* const> candidates,
                           std::vector<Argument>& arguments) {
  const bool is_fold = verb_of(*candidates.front()) == ListVerb::kFold;
  if (!is_fold || arguments.size() < 2 || arguments[0].waits() || arguments[1].waits()) return;
  const Type* list = arguments[0].value->type;
  hir::Expr*& start = arguments[1].value;
  const bool written = start->kind == hir::ExprKind::kInt || is_zero(*start);
  if (!written || !list->is(Kind::kList) || !list->element->is(Kind::kReal)) return;
  if (is_zero(*start) || list->element->is_double()) {
    start = make<hir::RealExpr>(hir::ExprKind::kReal, list->element, start->span,
                                constant_of(*start)->real);
  }
}

// The call as a loop, if it is one. The key of sort and what is looked for must be comparable.
hir::Expr* Checker::over_list(const NativeFunction& function, hir::CallNativeExpr& call) {
  const std::optional<ListVerb> verb = verb_of(function);
  if (!verb) return nullptr;
  const auto refuse = [&](const hir::Expr& value, std::string need, const Type* type) {
    report(make_diagnostic("E0313", value.span,
                           {std::string(function.name), std::move(need), type_phrase(type)}));
    return failed(call.span);
  };
  for (const hir::Expr* value : call.arguments) {
    if (value->type->is(Kind::kAny)) return failed(call.span);
  }
  hir::Expr* last = call.arguments.back();
  if (verb == ListVerb::kSort && !is_key(last->type->result))
    return refuse(*last, "a function that gives a number or a text", last->type->result);
  const bool searches = verb == ListVerb::kContains || verb == ListVerb::kIndexOf;
  if (searches && !has_deep_equality(last->type))
    return refuse(*last, "a value that == can compare", last->type);
  return make<hir::OverListExpr>(hir::ExprKind::kOverList, call.type, call.span, *verb,
                                 call.arguments, call.site);
}

// Functions handed to the library itself: it calls them while time stands still.
void Checker::note_callbacks(std::string_view name, const Signature& signature,
                             const std::vector<hir::Expr*>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (signature.parameters[i].type.form != TypePattern::Form::kFunction &&
        !values[i]->type->is(Kind::kFunction))
      continue;
    const hir::Function* function = nullptr;
    if (values[i]->kind == hir::ExprKind::kFunctionValue)
      function = values[i]->as<hir::FunctionValueExpr>().function;
    if (values[i]->kind == hir::ExprKind::kClosure)
      function = values[i]->as<hir::ClosureExpr>().function;
    if (function != nullptr) callbacks_.push_back({name, function, values[i]->span});
  }
}

}  // namespace armlet::lang
