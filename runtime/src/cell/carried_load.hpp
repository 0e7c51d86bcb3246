#pragma once

#include <memory>

#include "armlet/math/twist.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

// The object in the gripper of a carrier and what rests on it, as one rigid body in the frame of
// the flange.
Payload held_load(const World& world, int carrier);

// The arm with all that it carries: held, or mounted on one of its links; the same arm if that has
// no mass.
std::shared_ptr<const Robot> loaded_arm(const std::shared_ptr<const Robot>& model,
                                        const World& world, int carrier);

// The wrench that a load exerts on the tool that moves it, by weight and inertia: [f; m] about the
// tool point, world axes, N and N m.
//
// robot           in its motion; its own payload is left out.
// T_world_flange  pose of the flange at q.
// q, qd, qdd      n joint values, rad or m, and their rates.
Vector6d load_wrench(const Robot& robot, const Payload& load,
                     const Eigen::Isometry3d& T_world_flange, const Eigen::VectorXd& q,
                     const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd);

}  // namespace armlet
