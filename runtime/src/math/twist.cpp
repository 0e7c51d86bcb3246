#include "armlet/math/twist.hpp"

namespace armlet {

Eigen::Matrix3d hat(const Eigen::Vector3d& a) {
  Eigen::Matrix3d W;
  W << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return W;
}

Eigen::Vector3d vee(const Eigen::Matrix3d& W) {
  return 0.5 * Eigen::Vector3d(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
}

Vector6d rotate_twist(const Eigen::Matrix3d& R_a_b, const Vector6d& twist_b) {
  Vector6d twist_a;
  twist_a.head<3>() = R_a_b * twist_b.head<3>();
  twist_a.tail<3>() = R_a_b * twist_b.tail<3>();
  return twist_a;
}

Vector6d move_twist(const Vector6d& twist, const Eigen::Vector3d& p_q_from_p) {
  Vector6d moved = twist;
  moved.head<3>() += Eigen::Vector3d(twist.tail<3>()).cross(p_q_from_p);
  return moved;
}

Vector6d move_wrench(const Vector6d& wrench, const Eigen::Vector3d& p_q_from_p) {
  Vector6d moved = wrench;
  moved.tail<3>() -= p_q_from_p.cross(Eigen::Vector3d(wrench.head<3>()));
  return moved;
}

Matrix6d adjoint(const Eigen::Isometry3d& T_a_b) {
  const Eigen::Matrix3d R = T_a_b.linear();
  Matrix6d A = Matrix6d::Zero();
  A.topLeftCorner<3, 3>() = R;
  A.bottomRightCorner<3, 3>() = R;
  A.topRightCorner<3, 3>() = hat(T_a_b.translation()) * R;
  return A;
}

}  // namespace armlet
