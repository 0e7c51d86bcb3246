#pragma once
// Failures of grippers and hands that close.

#include "armlet/cell/gripper.hpp"
#include "armlet/interpreter/failure.hpp"

namespace armlet::bind {

// R0605: the reason why a gripper closed on nothing.
Failed fail_grasp(Vm& vm, int robot, const GraspResult& result);

}  // namespace armlet::bind
