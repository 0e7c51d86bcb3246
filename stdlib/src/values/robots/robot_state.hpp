#pragma once
// State and model of the robots that values of a program refer to.

#include "armlet/interpreter/answer.hpp"
#include "armlet/stdlib/host.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// The robot of the cell that a value of a program refers to.
inline const CellRobot& state_of(Vm& vm, const RobotRef& r) {
  return Host::of(vm).cell().robot(r.id);
}
inline const Robot& model_of(Vm& vm, const RobotRef& r) { return *state_of(vm, r).model; }

// R0651: a hand with fingers has no tool point, which this function needs.
Answer<void> check_arm(Vm& vm, int robot);

// Fails if another task moves the robot, if the robot is a hand whose fingers move, or if it is a
// finger whose hand moves.
Answer<void> check_idle(Vm& vm, int robot);
// R0617 for the part that moves (moving_part).
Failed fail_busy(Vm& vm, int part);

}  // namespace armlet::bind
