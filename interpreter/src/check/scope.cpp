#include "check/scope.hpp"

#include <algorithm>

namespace armlet::lang {

void Flow::merge(const Flow& other) {
  if (!other.reachable) return;
  if (!reachable) {
    *this = other;
    return;
  }
  for (const hir::Variable* variable : other.unset) {
    if (!is_unset(variable)) unset.push_back(variable);
  }
}

void Flow::assign(const hir::Variable* variable) { std::erase(unset, variable); }

bool Flow::is_unset(const hir::Variable* variable) const {
  return reachable && std::ranges::find(unset, variable) != unset.end();
}

void Use::add(hir::Variable* variable) {
  if (std::ranges::find(globals, variable) == globals.end()) globals.push_back(variable);
}

void Use::add(const hir::Function* function) {
  if (std::ranges::find(calls, function) == calls.end()) calls.push_back(function);
}

bool FunctionDecl::is_generic() const {
  return std::ranges::any_of(parameters, [](const Type* type) { return type == nullptr; });
}

const FunctionContext& FunctionContext::root() const {
  const FunctionContext* context = this;
  while (context->outer != nullptr) context = context->outer;
  return *context;
}

}  // namespace armlet::lang
