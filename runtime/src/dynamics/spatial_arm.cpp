#include "spatial_arm.hpp"

#include "chain/walk_out.hpp"
#include "plan_dynamics.hpp"

namespace armlet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of_axis(const WalkAxis& v) { return {v.xy[0], v.xy[1], v.z}; }

Moments moments_of_plan(const PlanLink& link) {
  Moments body;
  body.mass = link.mass;
  body.h = {link.h[0], link.h[1], link.h[2]};
  body.S << link.Sxx, link.Sxy, link.Sxz, link.Sxy, link.Syy, link.Syz, link.Sxz, link.Syz,
      link.Szz;
  return body;
}

}  // namespace

Vector6d spatial_cross(const Vector6d& motion, const Vector6d& other) {
  const Vector3d v = motion.head<3>(), w = motion.tail<3>();
  Vector6d result;
  result << w.cross(other.head<3>()) + v.cross(other.tail<3>()), w.cross(other.tail<3>());
  return result;
}

Vector6d spatial_cross_force(const Vector6d& motion, const Vector6d& force) {
  const Vector3d v = motion.head<3>(), w = motion.tail<3>();
  Vector6d result;
  result << w.cross(force.head<3>()), w.cross(force.tail<3>()) + v.cross(force.head<3>());
  return result;
}

Matrix6d spatial_cross_matrix(const Vector6d& motion) {
  Matrix6d X = Matrix6d::Zero();
  X.topLeftCorner<3, 3>() = hat(motion.tail<3>());
  X.topRightCorner<3, 3>() = hat(motion.head<3>());
  X.bottomRightCorner<3, 3>() = hat(motion.tail<3>());
  return X;
}

Matrix6d spatial_inertia(const Moments& body) {
  const Matrix3d h = hat(body.h);
  Matrix6d I;
  I << body.mass * Matrix3d::Identity(), -h, h, body.S.trace() * Matrix3d::Identity() - body.S;
  return I;
}

SpatialArm::SpatialArm(const Robot& robot, JointsIn q) {
  const WalkPlan& walk = robot.walk_plan();
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  const Vector3d origin(walk.base[9], walk.base[10], walk.base[11]);
  walk_out<kAnyCount>(
      walk, q.data(),
      [&](std::size_t i, const WalkFrame& at) {
        frame[i].linear() << vector_of_axis(at.x), vector_of_axis(at.y), vector_of_axis(at.z);
        frame[i].translation() = vector_of_axis(at.p) - origin;
        frame[i].makeAffine();
      },
      [](std::size_t, const WalkFrame&) {});
  base_acceleration << -robot.gravity(), Vector3d::Zero();
  for (std::size_t i = 0; i < plan.n; ++i) {
    const PlanLink& link = plan.links[i];
    const Vector3d z = link.sign * frame[i].linear().col(2);
    if (link.slides) {
      axis[i] << z, Vector3d::Zero();
    } else {
      axis[i] << frame[i].translation().cross(z), z;
    }
    inertia[i] = spatial_inertia(moments_of_plan(link).seen_from(frame[i]));
  }
}

}  // namespace armlet
