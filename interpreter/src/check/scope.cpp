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
  if (known.insert(variable).second) globals.push_back(variable);
}

void Use::add(const hir::Function* function) {
  if (known.insert(function).second) calls.push_back(function);
}

Local* FunctionContext::find(std::string_view name) {
  const auto found = places.find(name);
  return found == places.end() ? nullptr : &locals[found->second];
}

void FunctionContext::add(Local local) {
  places[local.variable->name] = locals.size();
  locals.push_back(local);
}

void FunctionContext::drop(std::size_t first) {
  for (std::size_t i = first; i < locals.size(); ++i) {
    const auto found = places.find(locals[i].variable->name);
    if (found != places.end() && found->second == i) places.erase(found);
  }
  locals.resize(first);
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
