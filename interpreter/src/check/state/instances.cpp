#include "check/state/instances.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace armlet::lang {

hir::Function* Instances::make_function(std::string_view name, Span span) {
  auto* function = arena_.make<hir::Function>();
  function->name = arena_.copy(name);
  function->span = span;
  function->index = static_cast<std::uint32_t>(functions_.size());
  function->result = types_.void_type();
  functions_.push_back(function);
  return function;
}

Instance& Instances::add(FunctionDecl& declaration, std::vector<const Type*> types, Span call) {
  Instance& instance = instances_.emplace_back();
  instance.types = std::move(types);
  instance.declaration = &declaration;
  instance.first_call = call;
  instance.function = make_function(declaration.node->name.text, declaration.node->span);
  declaration.instances.push_back(&instance);
  return instance;
}

void Instances::turn_round() { std::ranges::reverse(waiting_); }

Instance* Instances::next() {
  if (waiting_.empty()) return nullptr;
  Instance* const instance = waiting_.back();
  waiting_.pop_back();
  return instance;
}

}  // namespace armlet::lang
