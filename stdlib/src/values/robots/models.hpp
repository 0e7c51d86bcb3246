#pragma once
// Helpers shared by all functions that make robots.

#include <string_view>

#include "armlet/model/robot.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/robots/robot_state.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Puts a robot into the cell; R0630 if the cell refuses it.
Answer<RobotRef> add_robot(Vm& vm, Robot robot);

// The robot with the settings that every such function accepts: base, tool, name, all optional.
Robot finished(Robot robot, const PosC* base, const ToolValue* tool,
               std::optional<std::string_view> name = {});

// throws  ArgumentError for a word other than "standard" and "modified".
DhConvention convention_of(std::string_view word);

// Replaces the model of a robot; a failure while the robot moves, and R0630, which marks `part`, if
// `make` throws.
template <class Make>
Answer<void> exchange_model(Vm& vm, const RobotRef& r, CallPart part, const Make& make) try {
  if (!check_idle(vm, r.id)) return Failed{};
  Host::of(vm).cell().set_model(r.id, std::make_shared<const Robot>(make(model_of(vm, r))));
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0630"), error, part);
}

// Optional numbers of a row, such as the centre of mass in a joint row.
using Numbers = std::optional<std::span<const double>>;
using NumberRows = std::optional<std::span<const Slot>>;
// Three numbers; `what` they are: "gravity". `out` keeps its value if none are given.
Answer<void> read_vector3(Vm& vm, Numbers values, CallPart part, std::string_view what,
                          Eigen::Vector3d& out);
Answer<void> read_com(Vm& vm, Numbers values, CallPart part, Link& link);
// An inertia about the centre of mass, as rows of numbers or as a matrix; nullopt if it was left
// out.
using Inertia = std::optional<Eigen::Matrix3d>;
Answer<Inertia> inertia_argument(Vm& vm, NumberRows rows, CallPart part);
Answer<Inertia> inertia_argument(Vm& vm, const MatrixObj& matrix, CallPart part);
Answer<void> read_friction(Vm& vm, Numbers values, CallPart part, Link& link);

}  // namespace armlet::bind
