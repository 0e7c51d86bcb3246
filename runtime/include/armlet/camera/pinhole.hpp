#pragma once
// The pin-hole camera: from points in space to pixels, and back.

#include <Eigen/Geometry>
#include <array>

#include "armlet/core/error.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// A camera without a pose. Its frame: z forward, x right, y down; pixel centres are integers, so a
// picture spans -0.5 to width - 0.5.
//
// width, height  pixels.
// fx, fy         focal lengths, pixels.
// cx, cy         pixel of the optical axis.
// distortion     k1, k2, p1, p2, k3 of Brown and Conrady.
// near, far      smallest and largest depth z that is seen, m.
struct Intrinsics {
  int width = 640;
  int height = 480;
  double fx = 600.0;
  double fy = 600.0;
  double cx = 319.5;
  double cy = 239.5;
  std::array<double, 5> distortion{};
  double near = 0.01;
  double far = 20.0;

  [[nodiscard]] bool is_distorted() const { return distortion != std::array<double, 5>{}; }
  bool operator==(const Intrinsics&) const = default;
};

// Square pixels, the axis in the centre of the picture: f pixels, or f = W / (2 tan(fov / 2)).
//
// fov     angle of view across the width, rad, between 0 and pi.
// throws  ArgumentError as Pinhole, and for an angle outside of that.
Intrinsics intrinsics_from_focal(int width, int height, double focal);
Intrinsics intrinsics_from_fov(int width, int height, double fov);

// Projects points and finds the rays of pixels. With x = X/Z, y = Y/Z, r^2 = x^2 + y^2:
//   x_d = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2),   u = fx x_d + cx,
//   y_d = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y,   v = fy y_d + cy.
//
// source  D. C. Brown, Close-range camera calibration, Photogrammetric Engineering 37(8), 1971, in
//         the order of coefficients of OpenCV.
class Pinhole {
 public:
  // throws  ArgumentError with the number that is wrong: sides below 1 or above Image::kMostSide, a
  //         focal length that is not above zero, a number that is not finite, near not above zero
  //         or not below far.
  explicit Pinhole(const Intrinsics& intrinsics);

  [[nodiscard]] const Intrinsics& intrinsics() const { return intrinsics_; }
  // [fx 0 cx; 0 fy cy; 0 0 1].
  [[nodiscard]] Eigen::Matrix3d K() const;

  // Pixel of a point of the camera's frame; it may lie outside of the picture.
  //
  // p        m.
  // returns  an error "behind_camera" for a depth at or below near, "beyond_distortion" where the
  //          distortion is not unique: see largest_radius.
  // throws   ArgumentError for a coordinate that is not finite, as all functions below.
  [[nodiscard]] Result<Eigen::Vector2d> project(const Eigen::Vector3d& p) const;

  // The point (x, y, 1) of the camera's frame that is seen at a pixel; times a depth it is the
  // point at that depth.
  //
  // returns  an error "beyond_distortion" for a pixel at which no point within largest_radius is
  //          seen.
  [[nodiscard]] Result<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;

  // The point of the camera's frame at a pixel and a depth z, m, > 0.
  [[nodiscard]] Result<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel, double depth) const;

  // The pixel at which a camera without distortion but otherwise equal sees what this one sees at a
  // pixel.
  [[nodiscard]] Result<Eigen::Vector2d> undistort(const Eigen::Vector2d& pixel) const;

  // The derivative d(u, v) / d(x, y) at normalised coordinates (x, y).
  [[nodiscard]] Eigen::Matrix2d pixel_jacobian(const Eigen::Vector2d& x) const;

  // The distance r from the axis, in normalised coordinates, up to which r (1 + k1 r^2 + k2 r^4 +
  // k3 r^6) increases: beyond it two points would have the same pixel. Infinite without distortion.
  [[nodiscard]] double largest_radius() const { return largest_radius_; }

  // Whether a pixel lies in the picture: -0.5 <= u < width - 0.5, and v alike.
  [[nodiscard]] bool is_inside(const Eigen::Vector2d& pixel) const;

 private:
  [[nodiscard]] Eigen::Vector2d distorted(const Eigen::Vector2d& x) const;
  [[nodiscard]] Eigen::Matrix2d distortion_jacobian(const Eigen::Vector2d& x) const;
  [[nodiscard]] Error beyond(const Eigen::Vector2d& pixel) const;

  Intrinsics intrinsics_;
  double largest_radius_;
};

// Pose of a camera at `from` whose axis runs through p, with the direction `up` upwards in its
// picture. Where the axis is parallel to `up` (a camera straight above the table), x of the picture
// is x of the world, or y if that is parallel too.
//
// p, from, up  in the world, m; up need not be a unit vector.
// throws       ArgumentError if p and from are closer than 1e-9 m, up is zero, or a number is not
//              finite.
Eigen::Isometry3d looking_at(const Eigen::Vector3d& p, const Eigen::Vector3d& from,
                             const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

}  // namespace armlet
