#include "armlet/math/pose.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

// Coefficients of V = I + b W + c W^2 and V^-1 = I - W/2 + k W^2, W = hat(phi).
//
// The half-angle form of k is finite at an angle of pi, where the usual one is 0/0.
struct LeftJacobian {
  double b, c, k;
};

LeftJacobian left_jacobian(double angle) {
  const double a2 = angle * angle;
  if (angle < 1e-2) {
    return {1.0 / 2 - a2 / 24 + a2 * a2 / 720, 1.0 / 6 - a2 / 120 + a2 * a2 / 5040,
            1.0 / 12 + a2 / 720 + a2 * a2 / 30240};
  }
  const auto [s, c] = det::sincos(angle);
  const auto [s_half, c_half] = det::sincos(0.5 * angle);
  return {2.0 * s_half * s_half / a2, (angle - s) / (a2 * angle),
          (1.0 - 0.5 * angle * c_half / s_half) / a2};
}

}  // namespace

Eigen::Isometry3d make_pose(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R;
  T.translation() = p;
  return T;
}

Eigen::Isometry3d make_translation(const Eigen::Vector3d& p) {
  return make_pose(Eigen::Matrix3d::Identity(), p);
}

Eigen::Isometry3d pose_from_rpy(const Eigen::Vector3d& p, const Eigen::Vector3d& rpy) {
  return make_pose(R_from_rpy(rpy), p);
}

Vector6d pose_error(const Eigen::Isometry3d& T_from, const Eigen::Isometry3d& T_to) {
  Vector6d error;
  error.head<3>() = T_to.translation() - T_from.translation();
  error.tail<3>() = rotation_log(T_to.linear() * T_from.linear().transpose());
  return error;
}

double angle_between(const Eigen::Isometry3d& T_1, const Eigen::Isometry3d& T_2) {
  return angle_between(Eigen::Matrix3d(T_1.linear()), Eigen::Matrix3d(T_2.linear()));
}

Eigen::Isometry3d pose_exp(const Vector6d& xi) {
  const Eigen::Vector3d phi = xi.tail<3>();
  const LeftJacobian j = left_jacobian(phi.norm());
  const Eigen::Matrix3d W = hat(phi);
  const Eigen::Matrix3d V = Eigen::Matrix3d::Identity() + j.b * W + j.c * W * W;
  return make_pose(rotation_exp(phi), V * xi.head<3>());
}

Vector6d pose_log(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d phi = rotation_log(T.linear());
  const LeftJacobian j = left_jacobian(phi.norm());
  const Eigen::Matrix3d W = hat(phi);
  const Eigen::Matrix3d V_inverse = Eigen::Matrix3d::Identity() - 0.5 * W + j.k * W * W;
  Vector6d xi;
  xi.head<3>() = V_inverse * T.translation();
  xi.tail<3>() = phi;
  return xi;
}

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& T_0, const Eigen::Isometry3d& T_1,
                              double s) {
  // The ends are returned exactly, without the rounding errors of the exponential.
  if (s == 0.0) return T_0;
  if (s == 1.0) return T_1;
  return make_pose(interpolate(Eigen::Matrix3d(T_0.linear()), Eigen::Matrix3d(T_1.linear()), s),
                   T_0.translation() + s * (T_1.translation() - T_0.translation()));
}

Eigen::Isometry3d interpolate_screw(const Eigen::Isometry3d& T_0, const Eigen::Isometry3d& T_1,
                                    double s) {
  if (s == 0.0) return T_0;
  if (s == 1.0) return T_1;
  return T_0 * pose_exp(s * pose_log(T_0.inverse() * T_1));
}

Eigen::Isometry3d renormalised(const Eigen::Isometry3d& T) {
  return make_pose(renormalised(Eigen::Matrix3d(T.linear())), T.translation());
}

bool is_rotation(const Eigen::Matrix3d& R, double tolerance) {
  const double drift = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  return drift <= tolerance && R.determinant() > 0.0;
}

void check_pose(std::string_view name, const Eigen::Isometry3d& T) {
  check_finite(name, T.matrix().topRows<3>());
  const Eigen::Matrix3d R = T.linear();
  if (is_rotation(R)) return;
  throw ArgumentError(fmt::format(
      "The upper left 3x3 part of `{}` is not a rotation: its columns differ from perpendicular "
      "unit vectors by {:.3g} and its determinant is {:.3g}.",
      name, (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
      R.determinant()));
}

std::string format_pose(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d rpy = rpy_from_R(T.linear());
  return fmt::format("{}, rpy {} deg", format_point_mm(T.translation()),
                     format_vector(rpy * (180.0 / kPi), 1));
}

}  // namespace armlet
