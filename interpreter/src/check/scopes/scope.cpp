#include "check/scopes/scope.hpp"

#include <utility>

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

void Flow::merge(const Flow& other) {
  if (!other.reachable) return;
  if (!reachable) {
    *this = other;
    return;
  }
  unset.unite(other.unset);
}

void Flow::add_values_of(const Flow& other) {
  if (other.reachable) {
    unset.intersect(other.unset);
  } else {
    unset = {};
  }
}

bool Flow::is_unset(const hir::Variable* variable) const {
  return reachable && unset.contains(variable);
}

Flow merged(std::vector<Flow> ways) {
  if (ways.empty()) return {.reachable = false};
  for (std::size_t step = 1; step < ways.size(); step *= 2) {
    for (std::size_t i = 0; i + step < ways.size(); i += 2 * step) ways[i].merge(ways[i + step]);
  }
  return std::move(ways.front());
}

Local* FunctionContext::find(std::string_view name) {
  const auto found = places.find(name);
  return found == places.end() ? nullptr : &locals[found->second];
}

void FunctionContext::add(Local local) {
  places[local.variable->name] = locals.size();
  const Type& type = *local.variable->type;
  if (type.is(armlet::Kind::kHost) && type.host->is_ambient)
    ambient_places.push_back(locals.size());
  locals.push_back(local);
}

void FunctionContext::drop(std::size_t first) {
  for (std::size_t i = first; i < locals.size(); ++i) {
    const auto found = places.find(locals[i].variable->name);
    if (found != places.end() && found->second == i) places.erase(found);
  }
  while (!ambient_places.empty() && ambient_places.back() >= first) ambient_places.pop_back();
  locals.resize(first);
}

const FunctionContext& FunctionContext::root() const {
  const FunctionContext* context = this;
  while (context->outer != nullptr) context = context->outer;
  return *context;
}

}  // namespace armlet::lang
