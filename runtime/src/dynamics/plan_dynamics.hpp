#pragma once

#include "armlet/model/robot.hpp"
#include "dynamics_plan.hpp"

namespace armlet {

// The plan of a robot: robot.derived<RobotDynamics>().plan.
struct RobotDynamics {
  explicit RobotDynamics(const Robot& robot);

  DynamicsPlan plan{};
};

// The mass of a body with its first and second moments about the origin of a frame.
struct Moments {
  double mass = 0.0;
  Eigen::Vector3d h = Eigen::Vector3d::Zero();  // integral of r dm
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();  // integral of r r' dm

  Moments operator+(const Moments& other) const;
  // The moments in another frame.
  Moments seen_from(const Eigen::Isometry3d& T_to_from) const;
};

// The moments of a mass with its centre and its inertia about the centre.
Moments moments_of(double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& inertia);

// The frame of link i in the frame after Z_i of the robot's WalkPlan.
Eigen::Isometry3d link_in_joint(const Robot& robot, int i);

// The moments of a link, with the payload if it is the last, in its own frame, and in that after
// Z_i.
Moments moments_in_link(const Robot& robot, int i);
Moments moments_of_link(const Robot& robot, int i);

}  // namespace armlet
