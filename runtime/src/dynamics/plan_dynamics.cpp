#include "plan_dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// X_i of the chain for i > 0, or of the plan, whose link twists differ.
template <class Numbers>
Isometry3d x_step(const Numbers& numbers, std::size_t i) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() << 1.0, 0.0, 0.0, 0.0, numbers.cos_alpha[i], -numbers.sin_alpha[i], 0.0,
      numbers.sin_alpha[i], numbers.cos_alpha[i];
  X.translation().x() = numbers.a[i];
  return X;
}

void put_geometry(const WalkPlan& walk, std::size_t i, PlanLink& link) {
  link.sin_alpha = walk.sin_alpha[i];
  link.cos_alpha = walk.cos_alpha[i];
  link.a = walk.a[i];
  link.d = walk.d[i];
  link.slides = walk.q_to_theta[i] == 0.0;
  link.sign = link.slides ? walk.q_to_d[i] : walk.q_to_theta[i];
  link.twist = static_cast<unsigned char>(walk.twist[i]);
  link.has_a = walk.has_a[i];
  link.has_d = walk.has_d[i];
}

void put_moments(const Moments& body, PlanLink& link) {
  link.mass = body.mass;
  for (int r = 0; r < 3; ++r) link.h[r] = body.h[r];
  link.Sxx = body.S(0, 0);
  link.Sxy = body.S(0, 1);
  link.Sxz = body.S(0, 2);
  link.Syy = body.S(1, 1);
  link.Syz = body.S(1, 2);
  link.Szz = body.S(2, 2);
}

// Removes from a link the mass on the axis of its revolute joint, and returns it.
Moments take_axis(Moments& body) {
  Moments axis;
  axis.mass = body.mass;
  axis.h.z() = body.h.z();
  axis.S(2, 2) = body.S(2, 2);
  body.mass = body.h.z() = body.S(2, 2) = 0.0;
  return axis;
}

FrictionKind put_motor(const Link& from, PlanLink& link) {
  const double gear = std::abs(from.gear), squared = gear * gear;
  const Friction& friction = from.friction;
  link.motor_inertia = squared * from.motor_inertia;
  link.friction.viscous = squared * friction.viscous;
  link.friction.coulomb_plus = gear * friction.coulomb_plus;
  link.friction.coulomb_minus = gear * friction.coulomb_minus;
  const bool stribeck = friction.stribeck_speed > 0.0;
  if (stribeck) {
    link.friction.static_extra_plus = gear * friction.static_torque - link.friction.coulomb_plus;
    link.friction.static_extra_minus = -gear * friction.static_torque - link.friction.coulomb_minus;
    link.friction.stribeck_rate = gear / friction.stribeck_speed;
    return FrictionKind::kStribeck;
  }
  const bool any = link.friction.viscous != 0.0 || link.friction.coulomb_plus != 0.0 ||
                   link.friction.coulomb_minus != 0.0;
  return any ? FrictionKind::kCoulomb : FrictionKind::kNone;
}

// The first moment of the masses beyond joint i that have a constant position in frame i - 1.
Vector3d fixed_moment(const PlanLink& link) {
  const Vector3d along_axis(0.0, -link.sin_alpha, link.cos_alpha);
  return link.gravity.mass * (Vector3d(link.a, 0.0, 0.0) + link.d * along_axis);
}

}  // namespace

Moments moments_of(double mass, const Vector3d& com, const Matrix3d& inertia) {
  const Matrix3d even = 0.5 * (inertia + inertia.transpose());
  const Matrix3d about_centre = 0.5 * even.trace() * Matrix3d::Identity() - even;
  return {mass, mass * com, about_centre + mass * com * com.transpose()};
}

Moments Moments::operator+(const Moments& other) const {
  return {mass + other.mass, h + other.h, S + other.S};
}

Moments Moments::seen_from(const Isometry3d& T_to_from) const {
  const Matrix3d R = T_to_from.linear();
  const Vector3d p = T_to_from.translation();
  const Vector3d turned = R * h;
  const Matrix3d cross = turned * p.transpose();
  const Matrix3d second =
      R * S * R.transpose() + cross + cross.transpose() + mass * p * p.transpose();
  return {mass, turned + mass * p, 0.5 * (second + second.transpose())};
}

Isometry3d link_in_joint(const Robot& robot, int i) {
  const Chain& chain = robot.chain();
  const std::size_t k = static_cast<std::size_t>(i);
  Isometry3d T_joint_link = Isometry3d::Identity();
  if (chain.standard) T_joint_link = x_step(chain, k + 1);
  T_joint_link.matrix().middleRows<2>(1) *= robot.walk_plan().flip[k];
  return T_joint_link;
}

Moments moments_in_link(const Robot& robot, int i) {
  const Link& link = robot.link(i);
  Moments body = moments_of(link.mass, link.com, link.inertia);
  // The flange is the frame of the last link in both conventions.
  if (i + 1 == robot.rows()) {
    const Payload& payload = robot.payload();
    body = body + moments_of(payload.mass, payload.com, payload.inertia);
  }
  return body;
}

Moments moments_of_link(const Robot& robot, int i) {
  return moments_in_link(robot, i).seen_from(link_in_joint(robot, i));
}

RobotDynamics::RobotDynamics(const Robot& robot) {
  if (!robot.spec().no_dynamics.empty()) throw ArgumentError(robot.spec().no_dynamics);
  const WalkPlan& walk = robot.walk_plan();
  const std::size_t n = static_cast<std::size_t>(walk.n);
  plan.n = n;
  Matrix3d R_world_base;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) R_world_base(r, c) = walk.base[static_cast<std::size_t>(3 * c + r)];
  }
  const Vector3d acceleration = -(R_world_base.transpose() * robot.gravity());
  for (int r = 0; r < 3; ++r) plan.base_acceleration[r] = acceleration[r];

  Moments from_behind;
  Vector3d fixed_behind = Vector3d::Zero();
  double mass_beyond = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    PlanLink& link = plan.links[i];
    put_geometry(walk, i, link);
    plan.any_slides = plan.any_slides || link.slides;
    plan.friction = std::max(plan.friction, put_motor(robot.link(static_cast<int>(i)), link));
    Moments body = moments_of_link(robot, static_cast<int>(i)) + from_behind;
    from_behind = Moments();
    if (!link.slides) {
      Isometry3d to_parent = x_step(walk, i);
      to_parent.translate(Vector3d(0.0, 0.0, link.d));
      from_behind = take_axis(body).seen_from(to_parent);
    }
    put_moments(body, link);
    mass_beyond += body.mass;
    link.gravity.mass = mass_beyond;
    for (int r = 0; r < 3; ++r) link.gravity.h[r] = body.h[r] + fixed_behind[r];
    fixed_behind = fixed_moment(link);
  }
  plan.flat = 1;
  while (plan.flat < n && plan.links[plan.flat].twist == 0) ++plan.flat;
}

}  // namespace armlet
