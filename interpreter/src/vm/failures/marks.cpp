// The marks of failures of native functions, at the positions of the arguments, or of single
// elements of them, in the text.

#include <algorithm>
#include <optional>
#include <string>

#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/resource.hpp"
#include "vm/failures/failures.hpp"
#include "vocabulary/parameter_index.hpp"

namespace armlet::lang {

namespace {

using hir::Expr;
using hir::ExprKind;

const Expr* through_conversions(const Expr* expr) {
  while (expr != nullptr && expr->kind == ExprKind::kConvert)
    expr = expr->as<hir::ConvertExpr>().operand;
  return expr;
}

// The position of element `item` of a value in the text. Follows constant variables, and positions
// made from one list.
Span origin_of(const Expr* expr, int item) {
  constexpr int kMostSteps = 20;
  for (int step = 0; step < kMostSteps; ++step) {
    expr = through_conversions(expr);
    if (expr == nullptr) return {};
    if (expr->kind == ExprKind::kVariable) {
      expr = expr->as<hir::VariableExpr>().variable->init;
    } else if (expr->kind == ExprKind::kCallNative) {
      const auto& call = expr->as<hir::CallNativeExpr>();
      const bool from_list = call.arguments.size() == 1 && call.arguments[0]->type->is(Kind::kList);
      if (!from_list) return {};
      expr = call.arguments[0];
    } else {
      break;
    }
  }
  if (expr == nullptr || expr->kind != ExprKind::kList) return {};
  const auto& list = expr->as<hir::ListExpr>();
  return static_cast<std::size_t>(item) < list.items.size()
             ? list.items[static_cast<std::size_t>(item)]->span
             : Span{};
}

struct NativeCall {
  const hir::CallSite* site = nullptr;
  hir::Seq<Expr*> arguments;
  const NativeFunction* function = nullptr;  // null: an operation of the virtual machine
};

NativeCall call_at(const CodeSpan* at) {
  const Expr* expr = at == nullptr ? nullptr : at->expr;
  if (expr != nullptr && expr->kind == ExprKind::kGuarded)
    expr = expr->as<hir::GuardedExpr>().motion;
  if (expr != nullptr && expr->kind == ExprKind::kOverList) {
    const auto& loop = expr->as<hir::OverListExpr>();
    return {&loop.site, loop.operands, nullptr};
  }
  if (expr == nullptr || expr->kind != ExprKind::kCallNative) return {};
  const auto& call = expr->as<hir::CallNativeExpr>();
  return {&call.site, call.arguments, call.function};
}

// The index of the argument that is at fault; nothing if it is the call, or if this call does not
// have the argument.
std::optional<std::size_t> index_of(const NativeCall& call, const CallPart& part) {
  int index = part.operand();
  // A loop such as map(list, parseInt) passes elements of its first operand.
  if (!part.parameter().empty()) {
    index =
        call.function != nullptr ? parameter_index(call.function->signature, part.parameter()) : 0;
  }
  if (index < 0 || static_cast<std::size_t>(index) >= call.arguments.size()) return std::nullopt;
  return static_cast<std::size_t>(index);
}

// A mistake of the library: it names a parameter that its function does not have.
std::string unknown_parameter(const NativeCall& call, const CallPart& part) {
  if (part.parameter().empty() || call.function == nullptr || index_of(call, part)) return {};
  return "the library names the parameter `" + std::string(part.parameter()) + "`, but `" +
         std::string(call.function->name) + std::string(call.function->signature) +
         "` has no such parameter";
}

Span mark_of(const NativeCall& call, const Failure& failure, Span otherwise) {
  if (call.site == nullptr) return otherwise;
  if (failure.mark.is_callee()) return call.site->callee;
  const auto index = index_of(call, failure.mark);
  const bool written = index && !call.site->arguments[*index].empty();
  return written ? call.site->arguments[*index] : call.site->call;
}

void replace_all(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

// The text of a fix with its expressions inserted; empty if one of them is not known.
std::optional<std::string> fix_of(const VmState& state, const Failure& failure,
                                  const NativeCall& call, Span element, bool is_inside) {
  std::string fix = failure.fix;
  if (fix.find("{line}") != std::string::npos) {
    // The mark shows the argument itself, so the message need not repeat its text.
    if (element.empty() || is_inside) return std::nullopt;
    replace_all(fix, "line {line}", line_name(state, element));
  }
  if (fix.find("{arg}") != std::string::npos) {
    const auto index = index_of(call, failure.mark);
    if (!index) return std::nullopt;
    replace_all(fix, "{arg}", source_text(state, call.arguments[*index]->span));
  }
  return fix.empty() ? std::nullopt : std::optional(std::move(fix));
}

}  // namespace

Diagnostic diagnostic_of(const VmState& state, const Failure& failure) {
  Diagnostic out = make_diagnostic(failure.headline, {});
  const auto* earlier = static_cast<const CodeSpan*>(failure.place.code());
  const CodeSpan* at = earlier != nullptr ? earlier : code_span(state);
  const NativeCall call = call_at(at);
  out.mark = {mark_of(call, failure, at == nullptr ? Span{} : at->span), failure.label};
  out.why = failure.why;
  if (const std::string unknown = unknown_parameter(call, failure.mark); !unknown.empty())
    out.why = unknown;

  Span element;
  if (const auto index = index_of(call, failure.mark); index && failure.mark_element >= 0)
    element = origin_of(call.arguments[*index], failure.mark_element);
  bool inside = false;
  if (!element.empty()) {
    inside = element.begin >= out.mark.span.begin && element.end <= out.mark.span.end &&
             element.source == out.mark.span.source;
    if (inside) out.mark = {element, failure.element_label};
    if (!inside) out.related.push_back({element, failure.element_label});
  }
  if (std::optional<std::string> fix = fix_of(state, failure, call, element, inside)) {
    out.fix = Fix{std::move(*fix), {}, Confidence::kMaybe};
  }
  out.when = circumstances(state);
  out.when->resource = failure.resource.name;
  out.when->moved = failure.moved;
  if (failure.resource.type != nullptr) {
    const HostType& type = *failure.resource.type;
    out.when->resource_type = type.name;
    if (failure.moved && type.resource != nullptr)
      out.when->moved_text = *failure.moved ? type.resource->begun : type.resource->not_begun;
  }
  return out;
}

}  // namespace armlet::lang
