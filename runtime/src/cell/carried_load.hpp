#pragma once

#include <memory>

#include "armlet/math/twist.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

// What the hand of a carrier holds and what rests on it, as one rigid body seen from the flange.
Payload held_load(const World& world, int carrier);

// The arm with all that it carries: held, or mounted on one of its links; itself if that weighs
// nothing.
std::shared_ptr<const Robot> loaded_arm(const std::shared_ptr<const Robot>& model,
                                        const World& world, int carrier);

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
