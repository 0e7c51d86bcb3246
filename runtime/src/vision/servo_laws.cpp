#include "armlet/vision/servo_laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The number of singular values above a share of the largest.
Index rank_of(const VectorXd& s, double share = kSmallSingularValue) {
  Index rank = 0;
  while (rank < s.size() && s[rank] > share * s[0]) ++rank;
  return s.size() > 0 && s[0] > 0.0 ? rank : 0;
}

}  // namespace

MatrixXd point_interaction(const PlanePoints& points, const VectorXd& depths) {
  if (depths.size() != 1 && depths.size() != points.rows()) {
    throw ArgumentError(fmt::format("{} points have {} depths; give one for each, or one for all.",
                                    points.rows(), depths.size()));
  }
  check_finite("points", points);
  MatrixXd L(2 * points.rows(), 6);
  for (Index i = 0; i < points.rows(); ++i) {
    const double x = points(i, 0), y = points(i, 1), Z = depths[depths.size() == 1 ? 0 : i];
    check_positive("depth", Z);
    L.row(2 * i) << -1.0 / Z, 0.0, x / Z, x * y, -(1.0 + x * x), y;
    L.row(2 * i + 1) << 0.0, -1.0 / Z, y / Z, 1.0 + y * y, -x * y, -x;
  }
  return L;
}

MatrixXd law_interaction(ImageLaw law, const ImageGoal& goal) {
  if (goal.points.rows() != goal.wanted.rows()) {
    throw ArgumentError(fmt::format("{} points are seen and {} are wanted.", goal.points.rows(),
                                    goal.wanted.rows()));
  }
  switch (law) {
    case ImageLaw::kCurrent:
      return point_interaction(goal.points, goal.depths);
    case ImageLaw::kDesired:
      return point_interaction(goal.wanted, goal.depths_wanted);
    case ImageLaw::kMean:
      break;
  }
  return 0.5 * (point_interaction(goal.points, goal.depths) +
                point_interaction(goal.wanted, goal.depths_wanted));
}

VectorXd image_error(const ImageGoal& goal) {
  const PlanePoints difference = goal.points - goal.wanted;
  return Eigen::Map<const VectorXd>(difference.data(), difference.size());
}

ServoStep servo_step(const MatrixXd& A, const VectorXd& error, double gain) {
  check_positive("gain", gain);
  if (A.rows() != error.size()) {
    throw ArgumentError(
        fmt::format("A matrix of {} rows has no error of {} values.", A.rows(), error.size()));
  }
  check_finite("error", error);
  const SvdParts parts = singular_values(A);
  ServoStep out;
  out.rank = rank_of(parts.s);
  const VectorXd seen = parts.U.leftCols(out.rank).transpose() * error;
  out.motion = -gain * (parts.V.leftCols(out.rank) * seen.cwiseQuotient(parts.s.head(out.rank)));
  out.smallest = parts.s.size() > 0 ? parts.s[parts.s.size() - 1] : 0.0;
  out.condition =
      out.smallest > 0.0 ? parts.s[0] / out.smallest : std::numeric_limits<double>::infinity();
  const double whole = error.norm();
  if (whole > 0.0) out.unreachable = (error - parts.U.leftCols(out.rank) * seen).norm() / whole;
  return out;
}

MatrixXd uncontrollable_directions(const MatrixXd& A) {
  const SvdParts parts = full_singular_values(A);
  return parts.U.rightCols(A.rows() - rank_of(parts.s));
}

Index rank_above(const MatrixXd& A, double share) { return rank_of(singular_values(A).s, share); }

VectorXd null_motion(const MatrixXd& A, const VectorXd& wished) {
  if (A.cols() != wished.size()) {
    throw ArgumentError(
        fmt::format("A matrix of {} columns has no motion of {} joints.", A.cols(), wished.size()));
  }
  check_finite("wished", wished);
  const SvdParts parts = singular_values(A);
  const auto V = parts.V.leftCols(rank_of(parts.s));
  return wished - V * (V.transpose() * wished);
}

MatrixXd camera_jacobian(const Eigen::Ref<const MatrixXd>& J_world,
                         const Eigen::Matrix3d& R_world_tool,
                         const Eigen::Isometry3d& T_tool_camera) {
  if (J_world.rows() != 6)
    throw ArgumentError(fmt::format("A Jacobian has 6 rows, not {}.", J_world.rows()));
  check_finite("J_world", J_world);
  // Velocity of the camera's origin in the axes of the world, then in those of the camera.
  const Vector3d p = R_world_tool * T_tool_camera.translation();
  const Eigen::Matrix3d R_camera_world = (R_world_tool * T_tool_camera.linear()).transpose();
  MatrixXd out(6, J_world.cols());
  out.topRows(3) = R_camera_world * (J_world.topRows(3) - hat(p) * J_world.bottomRows(3));
  out.bottomRows(3) = R_camera_world * J_world.bottomRows(3);
  return out;
}

Vector6d position_twist(const Eigen::Isometry3d& T_wanted_camera, double gain) {
  check_positive("gain", gain);
  const Eigen::Matrix3d R = T_wanted_camera.linear();
  Vector6d out;
  out << -gain * (R.transpose() * T_wanted_camera.translation()), -gain * rotation_log(R);
  return out;
}

Vector6d hybrid_twist(const Eigen::Vector2d& point, const Eigen::Vector2d& wanted, double depth,
                      double depth_wanted, const Eigen::Matrix3d& R_wanted_camera, double gain) {
  check_positive("gain", gain);
  check_positive("depth", depth);
  check_positive("depth_wanted", depth_wanted);
  const double x = point.x(), y = point.y();
  const Vector3d error(x - wanted.x(), y - wanted.y(), det::log(depth / depth_wanted));
  const Vector3d w = -gain * rotation_log(R_wanted_camera);
  Eigen::Matrix3d L_v, L_w;
  L_v << -1.0, 0.0, x, 0.0, -1.0, y, 0.0, 0.0, -1.0;
  L_w << x * y, -(1.0 + x * x), y, 1.0 + y * y, -x * y, -x, -y, x, 0.0;
  // L_v is triangular: error' = L_v v / Z + L_w w.
  const Vector3d rest = depth * (-gain * error - L_w * w);
  Vector6d out;
  const double v_z = -rest.z();
  out << x * v_z - rest.x(), y * v_z - rest.y(), v_z, w;
  return out;
}

double AdaptiveGain::at(double largest_error) const {
  check_positive("at_zero", at_zero);
  check_positive("at_infinity", at_infinity);
  check_positive("slope", slope);
  if (at_zero < at_infinity) {
    throw ArgumentError(
        fmt::format("The gain at the goal is at least that for large errors, not {} and {} 1/s.",
                    at_zero, at_infinity));
  }
  if (!(largest_error >= 0.0) || !std::isfinite(largest_error))
    throw ArgumentError(fmt::format("An error is 0 or more and finite, not {}.", largest_error));
  const double range = at_zero - at_infinity;
  if (range == 0.0) return at_zero;
  return range * det::exp(-slope * largest_error / range) + at_infinity;
}

}  // namespace armlet
