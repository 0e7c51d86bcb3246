#include "values/settings.hpp"

#include <utility>

namespace armlet::bind {

BlockSettings settings_of(Vm& vm) {
  const auto* settings = static_cast<const BlockSettings*>(vm.task_data().get());
  return settings != nullptr ? *settings : BlockSettings{};
}

void replace_settings(Vm& vm, BlockSettings settings) {
  vm.task_data() = std::make_shared<const BlockSettings>(std::move(settings));
}

void open_settings(Vm& vm) {
  BlockSettings inner = settings_of(vm);
  inner.outer = std::static_pointer_cast<const BlockSettings>(vm.task_data());
  replace_settings(vm, std::move(inner));
}

void close_settings(Vm& vm) {
  const auto inner = std::static_pointer_cast<const BlockSettings>(vm.task_data());
  vm.task_data() = inner->outer;
}

}  // namespace armlet::bind
