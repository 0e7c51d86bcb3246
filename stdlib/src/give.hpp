#pragma once
// Lists of positions and frames as results, and joint values as arguments.

#include <optional>
#include <vector>

#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "values.hpp"

namespace armlet::bind {

template <class T>
Signal give_objects(Vm& vm, Slot* args, const std::vector<T>& items, Obj* (*make)(Vm&, const T&)) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(items.size()), true);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < items.size(); ++i) {
    list->data[i].o = make(vm, items[i]);
    if (list->data[i].o == nullptr) {
      release(vm, list);
      return Signal::kFail;
    }
  }
  return give(args, list);
}

// The joint values of a posJ or double[] argument, if there are as many as the robot has joints.
// Empty: the failure is set.
[[nodiscard]] std::optional<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, Slot s,
                                                            bool is_list, int parameter);

}  // namespace armlet::bind
