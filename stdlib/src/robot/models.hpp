#pragma once
// What every function that makes a robot has in common.

#include <string_view>

#include "armlet/cell/gripper.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "motion/moves.hpp"
#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Puts a robot into the cell; R0630 if the cell refuses it.
Answer<RobotRef> add_robot(Vm& vm, Robot robot);

// The robot with what every such function accepts: base, tool and a name, all optional.
Robot finished(Robot robot, const PosC* base, const ToolValue* tool,
               std::optional<std::string_view> name = {});

// throws  ArgumentError for another word than "standard" or "modified".
DhConvention convention_of(std::string_view word);

// R0605: why a hand closed on nothing.
Failed fail_grasp(Vm& vm, int robot, const GraspResult& result);

// Exchanges what a robot is; R0630 if `make` throws, and a failure while the robot moves.
template <class Make>
Answer<void> exchange_model(Vm& vm, const RobotRef& r, const Make& make) try {
  if (!check_idle(vm, r.id)) return Failed{};
  Host::of(vm).cell().set_model(r.id, std::make_shared<const Robot>(make(model_of(vm, r))));
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0630"), error, 1);
}

// The numbers of a joint row that describe its link, where they are given.
using Numbers = std::optional<std::span<const double>>;
using NumberRows = std::optional<std::span<const Slot>>;
Answer<void> read_com(Vm& vm, Numbers values, int parameter, Link& link);
// An inertia about the centre of mass, as rows of numbers or as a matrix; none where it is left
// out.
using Inertia = std::optional<Eigen::Matrix3d>;
Answer<Inertia> inertia_argument(Vm& vm, NumberRows rows, int parameter);
Answer<Inertia> inertia_argument(Vm& vm, const MatrixObj& matrix, int parameter);
Answer<void> read_friction(Vm& vm, Numbers values, int parameter, Link& link);

// Shapes that the rows of a block give its links, which are there; whether a link besides the base
// has one.
// throws  ArgumentError for a link or a mesh that is not there.
Answer<bool> add_bodies(Vm& vm, HostList<BodyRow> rows, RobotSpec& spec);

}  // namespace armlet::bind
