#include "armlet/camera/pinhole.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "armlet/core/format.hpp"
#include "armlet/image/image.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/real_roots.hpp"

namespace armlet {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

void check_intrinsics(const Intrinsics& i) {
  if (i.width < 1 || i.height < 1 || i.width > Image::kMostSide || i.height > Image::kMostSide) {
    throw ArgumentError(
        fmt::format("The picture of a camera has sides of 1 to {} pixels, not {} x {}.",
                    Image::kMostSide, i.width, i.height));
  }
  check_positive("focal length fx", i.fx);
  check_positive("focal length fy", i.fy);
  check_finite("centre cx", i.cx);
  check_finite("centre cy", i.cy);
  constexpr std::array<std::string_view, 5> kNames{"k1", "k2", "p1", "p2", "k3"};
  for (std::size_t k = 0; k < kNames.size(); ++k)
    check_finite(fmt::format("distortion {}", kNames[k]), i.distortion[k]);
  check_positive("near", i.near);
  check_finite("far", i.far);
  if (i.far <= i.near) {
    throw ArgumentError(
        fmt::format("A camera sees from `near` to `far`: near is {} m, far {} m; "
                    "expected near < far.",
                    i.near, i.far));
  }
}

// The smallest positive zero of d/dr (r + k1 r^3 + k2 r^5 + k3 r^7), a cubic in r^2.
double radius_of_fold(const std::array<double, 5>& d) {
  const double k1 = d[0], k2 = d[1], k3 = d[4];
  for (const double s : real_roots(Eigen::Vector4d(1.0, 3.0 * k1, 5.0 * k2, 7.0 * k3))) {
    if (s > 0.0) return std::sqrt(s);
  }
  return std::numeric_limits<double>::infinity();
}

double determinant(const Matrix2d& J) { return J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0); }

}  // namespace

Intrinsics intrinsics_from_focal(int width, int height, double focal) {
  const Intrinsics result{.width = width,
                          .height = height,
                          .fx = focal,
                          .fy = focal,
                          .cx = 0.5 * (width - 1.0),
                          .cy = 0.5 * (height - 1.0)};
  check_intrinsics(result);
  return result;
}

Intrinsics intrinsics_from_fov(int width, int height, double fov) {
  check_finite("fov", fov);
  if (fov <= 0.0 || fov >= std::numbers::pi) {
    throw ArgumentError(
        fmt::format("The angle of view of a camera lies between 0 and 180 deg, "
                    "not at {}.",
                    format_deg(fov)));
  }
  return intrinsics_from_focal(width, height, width / (2.0 * det::tan(0.5 * fov)));
}

Pinhole::Pinhole(const Intrinsics& intrinsics) : intrinsics_(intrinsics) {
  check_intrinsics(intrinsics);
  largest_radius_ = radius_of_fold(intrinsics.distortion);
}

Eigen::Matrix3d Pinhole::K() const {
  Eigen::Matrix3d K;
  K << intrinsics_.fx, 0.0, intrinsics_.cx, 0.0, intrinsics_.fy, intrinsics_.cy, 0.0, 0.0, 1.0;
  return K;
}

Vector2d Pinhole::distorted(const Vector2d& x) const {
  const auto& [k1, k2, p1, p2, k3] = intrinsics_.distortion;
  const double xx = x[0] * x[0], yy = x[1] * x[1], xy = x[0] * x[1], r2 = xx + yy;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x[0] * radial + 2.0 * p1 * xy + p2 * (r2 + 2.0 * xx),
          x[1] * radial + p1 * (r2 + 2.0 * yy) + 2.0 * p2 * xy};
}

Matrix2d Pinhole::distortion_jacobian(const Vector2d& x) const {
  const auto& [k1, k2, p1, p2, k3] = intrinsics_.distortion;
  const double r2 = x[0] * x[0] + x[1] * x[1];
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // d radial / dx = slope * x
  const double mixed = slope * x[0] * x[1] + 2.0 * p1 * x[0] + 2.0 * p2 * x[1];
  Matrix2d J;
  J << radial + slope * x[0] * x[0] + 2.0 * p1 * x[1] + 6.0 * p2 * x[0], mixed, mixed,
      radial + slope * x[1] * x[1] + 6.0 * p1 * x[1] + 2.0 * p2 * x[0];
  return J;
}

Matrix2d Pinhole::pixel_jacobian(const Vector2d& x) const {
  Matrix2d J = distortion_jacobian(x);
  J.row(0) *= intrinsics_.fx;
  J.row(1) *= intrinsics_.fy;
  return J;
}

Error Pinhole::beyond(const Vector2d& pixel) const {
  return {"beyond_distortion",
          fmt::format("No point is seen at pixel {}: the distortion of the camera folds back at "
                      "{} times the focal length from its axis.",
                      format_vector(pixel, 1), format_number(largest_radius_, 3))};
}

Result<Vector2d> Pinhole::project(const Vector3d& p) const {
  check_finite("point", p);
  if (p.z() <= intrinsics_.near) {
    return Error{
        "behind_camera",
        fmt::format("The point {} of the camera's frame is not in front of the camera: its "
                    "depth is {}, what is seen begins at {}.",
                    format_point_mm(p), format_mm(p.z()), format_mm(intrinsics_.near))};
  }
  Vector2d x(p.x() / p.z(), p.y() / p.z());
  if (intrinsics_.is_distorted()) {
    const double r = std::sqrt(x[0] * x[0] + x[1] * x[1]);
    if (r >= largest_radius_ || determinant(distortion_jacobian(x)) <= 0.0) {
      return Error{
          "beyond_distortion",
          fmt::format("The point {} lies {} times its depth from the camera's axis; the "
                      "distortion folds back at {}.",
                      format_point_mm(p), format_number(r), format_number(largest_radius_))};
    }
    x = distorted(x);
  }
  return Vector2d(intrinsics_.fx * x[0] + intrinsics_.cx, intrinsics_.fy * x[1] + intrinsics_.cy);
}

// Newton's method from the distorted point, with shorter steps where a full one would increase the
// error.
Result<Vector3d> Pinhole::ray(const Vector2d& pixel) const {
  check_finite("pixel", pixel);
  const Vector2d goal((pixel[0] - intrinsics_.cx) / intrinsics_.fx,
                      (pixel[1] - intrinsics_.cy) / intrinsics_.fy);
  if (!intrinsics_.is_distorted()) return Vector3d(goal[0], goal[1], 1.0);
  constexpr int kMostSteps = 60;
  const double tolerance = 1e-14 * (1.0 + std::sqrt(goal[0] * goal[0] + goal[1] * goal[1]));
  const auto distance = [&](const Vector2d& x) {
    const Vector2d e = goal - distorted(x);
    return std::sqrt(e[0] * e[0] + e[1] * e[1]);
  };
  const auto is_before_fold = [&](const Vector2d& x) {
    return std::sqrt(x[0] * x[0] + x[1] * x[1]) < largest_radius_ &&
           determinant(distortion_jacobian(x)) > 0.0;
  };
  Vector2d x = is_before_fold(goal) ? goal : Vector2d(0.0, 0.0);
  double left = distance(x);
  for (int step = 0; step < kMostSteps && left > 0.0; ++step) {
    const Matrix2d J = distortion_jacobian(x);
    const Vector2d e = goal - distorted(x);
    const double det = determinant(J);
    const Vector2d full((J(1, 1) * e[0] - J(0, 1) * e[1]) / det,
                        (J(0, 0) * e[1] - J(1, 0) * e[0]) / det);
    double share = 1.0;
    Vector2d next = x + full;
    while (share > 1e-6 && !(is_before_fold(next) && distance(next) < left)) {
      share *= 0.5;
      next = x + share * full;
    }
    if (share <= 1e-6) break;
    x = next;
    left = distance(x);
  }
  if (!(left <= tolerance)) return beyond(pixel);
  return Vector3d(x[0], x[1], 1.0);
}

Result<Vector3d> Pinhole::unproject(const Vector2d& pixel, double depth) const {
  check_positive("depth", depth);
  const Result<Vector3d> direction = ray(pixel);
  if (!direction) return direction.error();
  return Vector3d(depth * direction.value());
}

Result<Vector2d> Pinhole::undistort(const Vector2d& pixel) const {
  const Result<Vector3d> direction = ray(pixel);
  if (!direction) return direction.error();
  return Vector2d(intrinsics_.fx * direction->x() + intrinsics_.cx,
                  intrinsics_.fy * direction->y() + intrinsics_.cy);
}

bool Pinhole::is_inside(const Vector2d& pixel) const {
  return pixel[0] >= -0.5 && pixel[0] < intrinsics_.width - 0.5 && pixel[1] >= -0.5 &&
         pixel[1] < intrinsics_.height - 0.5;
}

Eigen::Isometry3d looking_at(const Vector3d& p, const Vector3d& from, const Vector3d& up) {
  check_finite("point", p);
  check_finite("from", from);
  check_finite("up", up);
  const Vector3d way = p - from;
  const double distance = way.norm(), height = up.norm();
  if (distance < 1e-9) {
    throw ArgumentError(fmt::format("A camera at {} cannot look at {}: it is the same point.",
                                    format_point_mm(from), format_point_mm(p)));
  }
  if (height == 0.0) throw ArgumentError("`up` of a camera is (0, 0, 0); expected a direction.");
  const Vector3d z = way / distance;
  Vector3d x = z.cross(up / height);
  if (x.norm() < 1e-9) {  // straight up or down
    x = Vector3d::UnitX() - z.x() * z;
    if (x.norm() < 1e-9) x = Vector3d::UnitY() - z.y() * z;
  }
  x /= x.norm();
  Eigen::Matrix3d R;
  R << x, z.cross(x), z;
  return make_pose(R, from);
}

}  // namespace armlet
