#pragma once

#include "armlet/math/twist.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

// All that travels with a carrier, as one rigid body seen from its frame: what the hand holds and
// what rests on it.
Payload carried_load(const World& world, int carrier);

// What a load exerts on the hand that moves it, weight and inertia: [f; m] about the tool point,
// world axes, N and N m.
//
// robot          as it moves; its own payload does not count.
// T_world_flange where it is at q.
// q, qd, qdd     n joint values, rad or m, and their rates.
Vector6d load_wrench(const Robot& robot, const Payload& load,
                     const Eigen::Isometry3d& T_world_flange, const Eigen::VectorXd& q,
                     const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd);

}  // namespace armlet
