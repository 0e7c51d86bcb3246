#pragma once

#include <string>
#include <utility>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "random_arm.hpp"

namespace armlet {

// A rigid body of a few points, so that its inertia is one that bodies have.
inline Link random_link(Random& random) {
  Link link;
  Eigen::Vector3d points[4];
  double masses[4];
  for (int k = 0; k < 4; ++k) {
    masses[k] = random.uniform(0.2, 2.0);
    for (double& x : points[k]) x = random.uniform(-0.3, 0.3);
    link.mass += masses[k];
    link.com += masses[k] * points[k];
  }
  link.com /= link.mass;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d r = points[k] - link.com;
    link.inertia += masses[k] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  if (random.below(2) == 0) {
    link.gear = random.uniform(-80.0, 80.0);
    link.motor_inertia = random.uniform(0.0, 2e-4);
  }
  return link;
}

// An arm of random_arm() with masses and a gravity in any direction.
inline Robot random_heavy_arm(Random& random, int n) {
  RobotSpec spec = random_arm(random, n).spec();
  spec.links.clear();
  for (int i = 0; i < n; ++i) spec.links.push_back(random_link(random));
  for (double& g : spec.gravity) g = random.uniform(-9.81, 9.81);
  return Robot(spec);
}

inline Eigen::VectorXd random_rates(Random& random, int n) {
  Eigen::VectorXd rates(n);
  for (double& rate : rates) rate = random.uniform(-2.0, 2.0);
  return rates;
}

inline Eigen::Vector3d random_point(Random& random, double most) {
  Eigen::Vector3d p;
  for (double& x : p) x = random.uniform(-most, most);
  return p;
}

inline Eigen::Isometry3d random_step(Random& random) {
  return make_translation(random_point(random, 0.4)) *
         Eigen::AngleAxisd(random.uniform(-3.0, 3.0), random_point(random, 1.0).normalized());
}

// Of each of n + copies joints of a chain the actuator that it copies; -1: it has its own.
inline std::vector<int> random_copies(Random& random, int n, int copies) {
  const int rows = n + copies;
  std::vector<int> copies_of(static_cast<std::size_t>(rows), -1);
  for (int left = copies; left > 0;) {
    int& row = copies_of[random.below(static_cast<std::uint64_t>(rows))];
    if (row >= 0) continue;
    row = static_cast<int>(random.below(static_cast<std::uint64_t>(n)));
    --left;
  }
  return copies_of;
}

// A chain from the base to the link "end" with n actuators and as many joints more as `copies` that
// copy one of the others each, in any order; with fixed links in between, rotors, friction, and
// beside the chain links that follow joints of it.
inline Mechanism random_coupled_chain(Random& random, int n, int copies) {
  MechanismSpec spec{.name = "coupled"};
  const int rows = n + copies;
  const std::vector<int> copies_of = random_copies(random, n, copies);
  const auto add = [&](const std::string& name, int parent, BodyJoint joint) {
    Body body{.name = name, .joint_name = "j_" + name, .parent = parent, .joint = joint};
    body.T_parent_joint = random_step(random);
    body.axis = random_point(random, 1.0).normalized();
    body.link = random_link(random);
    if (joint != BodyJoint::kFixed) {
      body.link.friction = {.viscous = random.uniform(0.0, 1e-3),
                            .coulomb_plus = random.uniform(0.0, 0.02),
                            .coulomb_minus = -random.uniform(0.0, 0.02)};
    }
    spec.bodies.push_back(std::move(body));
    return static_cast<int>(spec.bodies.size()) - 1;
  };
  const auto kind = [&] {
    return random.below(4) == 0 ? BodyJoint::kPrismatic : BodyJoint::kRevolute;
  };
  std::vector<std::pair<int, double>> drive;  // of each joint: actuator and ratio
  int last = -1;
  const auto ratio = [&] { return (random.below(2) == 0 ? -1.0 : 1.0) * random.uniform(0.3, 1.5); };
  for (int k = 0; k < rows; ++k) {
    last = add("link" + std::to_string(k + 1), last, kind());
    const int of = copies_of[static_cast<std::size_t>(k)];
    if (of < 0) {
      const Body& own = spec.bodies.back();
      const double most = own.joint == BodyJoint::kRevolute ? 2.0 : 0.3;
      drive.emplace_back(static_cast<int>(spec.actuators.size()), 1.0);
      spec.actuators.push_back({.name = own.joint_name,
                                .lower = -most,
                                .upper = most,
                                .max_speed = 3.0,
                                .max_effort = 90.0});
    } else {
      drive.emplace_back(of, ratio());
    }
    if (random.below(3) == 0) {
      add("beside" + std::to_string(k + 1), last, BodyJoint::kRevolute);
      drive.emplace_back(static_cast<int>(random.below(static_cast<std::uint64_t>(n))), ratio());
    }
    if (random.below(3) == 0) last = add("fixed" + std::to_string(k + 1), last, BodyJoint::kFixed);
  }
  add("end", last, BodyJoint::kFixed);
  const auto joints = static_cast<Eigen::Index>(drive.size());
  spec.coupling = Eigen::MatrixXd::Zero(joints, n);
  spec.offset = Eigen::VectorXd::Zero(joints);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const auto [actuator, factor] = drive[static_cast<std::size_t>(j)];
    spec.coupling(j, actuator) = factor;
    if (factor != 1.0) spec.offset[j] = random.uniform(-0.5, 0.5);
  }
  spec.tips.push_back({.name = "tool",
                       .body = static_cast<int>(spec.bodies.size()) - 1,
                       .T_body_tip = random_step(random)});
  return Mechanism(std::move(spec));
}

}  // namespace armlet
