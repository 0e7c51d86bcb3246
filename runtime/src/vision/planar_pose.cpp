#include "armlet/vision/planar_pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/vision/homography.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::Isometry3d;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr double kFlat = 1e-6;  // of the size of the object
constexpr int kRefinements = 20;

// The frame of a plane through points: z is its normal.
struct Plane {
  Isometry3d T_obj_plane = Isometry3d::Identity();
  PlanePoints flat;       // in the plane
  double size = 0.0;      // the root of the mean square distance from the centre, m
  double width = 0.0;     // the same across the longest direction
  double farthest = 0.0;  // distance from the plane, m
};

Plane plane_of(const Points3& points) {
  Plane out;
  const Vector3d middle = points.colwise().mean();
  const Points3 around = points.rowwise() - middle.transpose();
  // Axes of the scatter matrix: the third one is the normal.
  const SvdParts parts = full_singular_values(around.transpose() * around);
  Matrix3d axes = parts.U;
  // Planes that lie in z = 0 already keep their axes.
  if (around.col(2).isZero(0.0)) axes = Matrix3d::Identity();
  if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
  out.T_obj_plane.linear() = axes;
  out.T_obj_plane.translation() = middle;
  const Points3 turned = around * axes;
  out.flat = turned.leftCols(2);
  out.farthest = turned.col(2).cwiseAbs().maxCoeff();
  const double n = static_cast<double>(points.rows());
  out.size = std::sqrt(parts.s.sum() / n);
  out.width = std::sqrt(std::max(0.0, parts.s[1]) / n);
  return out;
}

// The best translation for a given orientation: its equations are linear.
Vector3d translation_for(const Matrix3d& R, const PlanePoints& flat, const PlanePoints& seen) {
  Matrix3d A = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (Index i = 0; i < flat.rows(); ++i) {
    const Vector3d p = R.leftCols<2>() * flat.row(i).transpose();
    const double x = seen(i, 0), y = seen(i, 1);
    Eigen::Matrix<double, 2, 3> rows;
    rows << 1, 0, -x, 0, 1, -y;
    A += rows.transpose() * rows;
    b += rows.transpose() * Vector2d(x * p.z() - p.x(), y * p.z() - p.y());
  }
  return SymmetricFactors<3>(A).solve(b);
}

// Root mean square distance in the picture; infinity if a point is not in front of the camera.
double error_of(const Isometry3d& T, const PlanePoints& flat, const PlanePoints& seen) {
  double sum = 0.0;
  for (Index i = 0; i < flat.rows(); ++i) {
    const Vector3d p = T * Vector3d(flat(i, 0), flat(i, 1), 0.0);
    if (!(p.z() > 0.0)) return std::numeric_limits<double>::infinity();
    sum += Vector2d(p.x() / p.z() - seen(i, 0), p.y() / p.z() - seen(i, 1)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(flat.rows()));
}

// Gauss-Newton steps as long as they reduce the error.
FoundPose refined(const Isometry3d& start, const PlanePoints& flat, const PlanePoints& seen) {
  FoundPose best{start, error_of(start, flat, seen)};
  for (int step = 0; step < kRefinements && std::isfinite(best.error); ++step) {
    Matrix6d A = Matrix6d::Zero();
    Vector6d b = Vector6d::Zero();
    for (Index i = 0; i < flat.rows(); ++i) {
      const Vector3d p = best.T_camera_obj * Vector3d(flat(i, 0), flat(i, 1), 0.0);
      const double x = p.x() / p.z(), y = p.y() / p.z(), w = 1.0 / p.z();
      Eigen::Matrix<double, 2, 3> by_point;
      by_point << w, 0, -w * x, 0, w, -w * y;
      Eigen::Matrix<double, 2, 6> rows;
      rows << by_point, -by_point * hat(p - best.T_camera_obj.translation());
      A += rows.transpose() * rows;
      b += rows.transpose() * Vector2d(seen(i, 0) - x, seen(i, 1) - y);
    }
    const Vector6d change = SymmetricFactors<6>(A).solve(b);
    if (!change.allFinite()) break;
    Isometry3d next = best.T_camera_obj;
    next.translation() += change.head<3>();
    next.linear() = renormalised(rotation_exp(change.tail<3>()) * next.linear());
    const double error = error_of(next, flat, seen);
    if (!(error < best.error)) break;
    best = {next, error};
  }
  return best;
}

// The two orientations that the homography of a plane and its derivative in the centre allow, and
// the position of the centre.
struct Candidates {
  std::array<Matrix3d, 2> R_camera_plane;
  Vector3d middle;
};

//
// source  Collins, Bartoli 2014, section 4 (equations 21 to 26 of the algorithm).
std::optional<Candidates> candidates(const Matrix3d& H) {
  const double scale = H(2, 2);
  if (std::abs(scale) < 1e-12 * H.norm()) return std::nullopt;
  const Matrix3d N = H / scale;
  const double p = N(0, 2), q = N(1, 2);  // image of the centre
  Matrix2d J;                             // derivative of the image of a point near the centre
  J << N(0, 0) - N(2, 0) * p, N(0, 1) - N(2, 1) * p, N(1, 0) - N(2, 0) * q, N(1, 1) - N(2, 1) * q;
  // Rotates the optical axis to the ray of the centre.
  const Vector3d ray = Vector3d(p, q, 1.0).normalized();
  const Vector3d turn = Vector3d::UnitZ().cross(ray);
  Matrix3d R_ray = Matrix3d::Identity();
  if (turn.norm() > 0.0) {
    const Matrix3d K = hat(turn);
    R_ray += K + K * K / (1.0 + ray.z());
  }
  Eigen::Matrix<double, 2, 3> across;
  across << 1, 0, -p, 0, 1, -q;
  const Matrix2d B = (across * R_ray).leftCols<2>();
  const Matrix2d A = B.inverse() * J;
  // The largest singular value of a 2 x 2 matrix.
  const Matrix2d AtA = A * A.transpose();
  const double half = 0.5 * AtA.trace(), apart = 0.5 * (AtA(0, 0) - AtA(1, 1));
  const double gamma = std::sqrt(half + std::sqrt(apart * apart + AtA(0, 1) * AtA(0, 1)));
  if (!(gamma > 0.0) || !std::isfinite(gamma)) return std::nullopt;
  const Matrix2d R22 = A / gamma;
  const Matrix2d left = Matrix2d::Identity() - R22.transpose() * R22;
  double b0 = std::sqrt(std::max(0.0, left(0, 0)));
  double b1 = std::sqrt(std::max(0.0, left(1, 1)));
  if (left(0, 1) < 0.0) b1 = -b1;
  Candidates out{{}, Vector3d(p, q, 1.0) / gamma};
  for (int k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    Matrix3d R;
    R.col(0) << R22(0, 0), R22(1, 0), sign * b0;
    R.col(1) << R22(0, 1), R22(1, 1), sign * b1;
    R.col(2) = R.col(0).cross(R.col(1));
    out.R_camera_plane[static_cast<std::size_t>(k)] = renormalised(R_ray * R);
  }
  return out;
}

void check(const Points3& points, const PlanePoints& seen) {
  if (points.rows() != seen.rows()) {
    throw ArgumentError(
        fmt::format("An object of {} points is seen in {}.", points.rows(), seen.rows()));
  }
  if (points.rows() < 4)
    throw ArgumentError(fmt::format("A pose needs at least 4 points, not {}.", points.rows()));
  check_finite("points", points);
  check_finite("seen", seen);
}

}  // namespace

Result<PlanarPose> planar_pose(const Points3& points, const PlanePoints& seen) {
  check(points, seen);
  const Plane plane = plane_of(points);
  if (!(plane.width > kFlat * plane.size))
    return Error{"degenerate", "the points of the object lie on one line"};
  if (plane.farthest > 1e-4 * plane.size) {
    return Error{"not_planar",
                 fmt::format("the points do not lie in one plane: one is {:.3g} mm beside it",
                             1e3 * plane.farthest)};
  }
  const Result<Matrix3d> H = homography(plane.flat, seen);
  if (!H.ok()) return Error{"degenerate", H.error().message};
  const auto starts = candidates(*H);
  if (!starts) return Error{"behind", "no pose has all points in front of the camera"};
  std::array<FoundPose, 2> found;
  for (std::size_t k = 0; k < 2; ++k) {
    Isometry3d T = Isometry3d::Identity();
    T.linear() = starts->R_camera_plane[k];
    T.translation() = translation_for(T.linear(), plane.flat, seen);
    Isometry3d other = T;  // for pictures so noisy that the equations give a pose behind the camera
    other.translation() = starts->middle;
    const bool is_worse = error_of(T, plane.flat, seen) > error_of(other, plane.flat, seen);
    found[k] = refined(is_worse ? other : T, plane.flat, seen);
    found[k].T_camera_obj = found[k].T_camera_obj * plane.T_obj_plane.inverse();
  }
  if (found[1].error < found[0].error) std::swap(found[0], found[1]);
  if (!std::isfinite(found[0].error))
    return Error{"behind", "no pose has all points in front of the camera"};
  if (!std::isfinite(found[1].error)) found[1] = found[0];
  return PlanarPose{found[0], found[1]};
}

}  // namespace armlet
