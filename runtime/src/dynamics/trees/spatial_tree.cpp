#include "spatial_tree.hpp"

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "model/body_inertia.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t index(int i) { return static_cast<std::size_t>(i); }
int at(std::size_t i) { return static_cast<int>(i); }

Vector6d axis_of(const Body& body, const Isometry3d& T) {
  const Vector3d z = T.linear() * body.axis;
  Vector6d axis = Vector6d::Zero();
  if (body.joint == BodyJoint::kRevolute) axis << T.translation().cross(z), z;
  if (body.joint == BodyJoint::kPrismatic) axis.head<3>() = z;
  return axis;
}

Matrix6d inertia_of(const Link& link, const Isometry3d& T) {
  const Vector3d c = T * link.com;
  const Matrix3d h = hat(link.mass * c);
  Matrix6d I;
  I << link.mass * Matrix3d::Identity(), -h, h,
      T.linear() * link.inertia * T.linear().transpose() - h * hat(c);
  return I;
}

}  // namespace

void check_values(std::string_view name, const VectorXd& values, const Mechanism& mechanism) {
  check_size(name, values.size(), mechanism.actuator_count());
  check_finite(name, values);
}

void check_motion(const Mechanism& mechanism, const MechanismMotion& motion,
                  const Vector3d& gravity) {
  check_values("q", motion.q, mechanism);
  check_values("qd", motion.qd, mechanism);
  check_values("qdd", motion.qdd, mechanism);
  check_finite("gravity", gravity);
}

SpatialTree::SpatialTree(const Mechanism& mechanism, const VectorXd& q) : mechanism_(mechanism) {
  const VectorXd values = mechanism.joint_values(q);
  for (std::size_t i = 0; i < mechanism.bodies().size(); ++i) {
    const Body& body = mechanism.bodies()[i];
    const int joint = mechanism.joint_of(at(i));
    Isometry3d T =
        body.parent >= 0 ? frames_[index(body.parent)] * body.T_parent_joint : body.T_parent_joint;
    frames_.push_back(joint >= 0 ? T * joint_motion(body, values[joint]) : T);
    axes_.push_back(axis_of(body, frames_[i]));
    inertias_.push_back(inertia_of(body.link, frames_[i]));
  }
}

std::vector<BodyMotion> SpatialTree::motions(const VectorXd& rates, const VectorXd& accelerations,
                                             const Vector3d& gravity) const {
  Vector6d falling;
  falling << -gravity, Vector3d::Zero();
  std::vector<BodyMotion> out(frames_.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int parent = mechanism_.bodies()[i].parent, joint = mechanism_.joint_of(at(i));
    out[i] = parent < 0 ? BodyMotion{Vector6d::Zero(), falling} : out[index(parent)];
    if (joint < 0) continue;
    const Vector6d own = axes_[i] * rates[joint];
    out[i].v += own;
    out[i].a += axes_[i] * accelerations[joint] + spatial_cross(out[i].v, own);
  }
  return out;
}

VectorXd SpatialTree::joint_forces(const VectorXd& rates, const VectorXd& accelerations,
                                   const Vector3d& gravity) const {
  const std::vector<BodyMotion> motion = motions(rates, accelerations, gravity);
  std::vector<Vector6d> f(motion.size());
  for (std::size_t i = 0; i < f.size(); ++i)
    f[i] =
        inertias_[i] * motion[i].a + spatial_cross_force(motion[i].v, inertias_[i] * motion[i].v);
  VectorXd tau(mechanism_.joint_count());
  for (std::size_t i = f.size(); i-- > 0;) {
    const int parent = mechanism_.bodies()[i].parent, joint = mechanism_.joint_of(at(i));
    if (joint >= 0) tau[joint] = axes_[i].dot(f[i]);
    if (parent >= 0) f[index(parent)] += f[i];
  }
  return tau;
}

MatrixXd SpatialTree::joint_inertia() const {
  MatrixXd H = MatrixXd::Zero(mechanism_.joint_count(), mechanism_.joint_count());
  std::vector<Matrix6d> composite = inertias_;
  for (std::size_t i = frames_.size(); i-- > 0;) {
    const Body& body = mechanism_.bodies()[i];
    if (body.parent >= 0) composite[index(body.parent)] += composite[i];
    const int joint = mechanism_.joint_of(at(i));
    if (joint < 0) continue;
    const Vector6d force = composite[i] * axes_[i];
    H(joint, joint) = axes_[i].dot(force) + squared_gear(body.link) * body.link.motor_inertia;
    for (int k = body.parent; k >= 0; k = mechanism_.bodies()[index(k)].parent) {
      const int other = mechanism_.joint_of(k);
      if (other >= 0) H(joint, other) = H(other, joint) = axes_[index(k)].dot(force);
    }
  }
  return H;
}

}  // namespace armlet
