#pragma once

#include <string_view>
#include <vector>

#include "armlet/dynamics/mechanism_dynamics.hpp"
#include "dynamics/spatial_arm.hpp"

namespace armlet {

inline double squared_gear(const Link& link) { return link.gear * link.gear; }

// Friction at the joint, as described in Link::friction.
double link_friction(const Link& link, double qd);

// Throws ArgumentError unless there is one finite value for each actuator.
void check_values(std::string_view name, const Eigen::VectorXd& values, const Mechanism& mechanism);
void check_motion(const Mechanism& mechanism, const MechanismMotion& motion,
                  const Eigen::Vector3d& gravity);

// The velocity and acceleration of a body, as spatial vectors.
struct BodyMotion {
  Vector6d v, a;
};

// A tree in one configuration, in spatial vectors about the origin of the base and in its axes, so
// that no vector has to be transformed from body to body.
class SpatialTree {
 public:
  SpatialTree(const Mechanism& mechanism, const Eigen::VectorXd& q);

  // Motions of all bodies, for rates of the joints; gravity is an acceleration of the base.
  [[nodiscard]] std::vector<BodyMotion> motions(const Eigen::VectorXd& rates,
                                                const Eigen::VectorXd& accelerations,
                                                const Eigen::Vector3d& gravity) const;

  // The forces of all joints, without motors and friction.
  [[nodiscard]] Eigen::VectorXd joint_forces(const Eigen::VectorXd& rates,
                                             const Eigen::VectorXd& accelerations,
                                             const Eigen::Vector3d& gravity) const;

  // The inertia matrix of all joints, with the rotors.
  [[nodiscard]] Eigen::MatrixXd joint_inertia() const;

  // The frames of the bodies in the base, and the motions of their joints for a rate of 1.
  [[nodiscard]] const std::vector<Eigen::Isometry3d>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<Vector6d>& axes() const { return axes_; }

 private:
  const Mechanism& mechanism_;
  std::vector<Eigen::Isometry3d> frames_;
  std::vector<Vector6d> axes_;
  std::vector<Matrix6d> inertias_;
};

}  // namespace armlet
