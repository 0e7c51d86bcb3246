#pragma once
// The pose of a flat object from one picture of its points.

#include <Eigen/Geometry>

#include "armlet/core/error.hpp"
#include "armlet/math/eigen_layout.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// A pose and its error.
//
// error  root of the mean square distance between the observed points and those of the pose, in
//        normalised coordinates (times the focal length: pixels).
struct FoundPose {
  Eigen::Isometry3d T_camera_obj = Eigen::Isometry3d::Identity();
  double error = 0.0;
};

// The two poses of a plane. A small or distant plane looks nearly the same in two orientations; the
// better one is first.
struct PlanarPose {
  FoundPose best, other;

  // Whether the two fit the picture almost equally well: the error of the other is less than 20 %
  // larger.
  [[nodiscard]] bool is_ambiguous() const { return other.error < 1.2 * best.error; }
};

// The pose of points of a plane from one picture of them, refined by least squares.
//
// points  n x 3, n >= 4, of the object in its own frame, m, all in one plane.
// seen    n x 2, x = X/Z and y = Y/Z, without distortion.
// returns the two poses with all points in front of the camera, or an error: "degenerate" if the
//         points are on a line or their picture is, "not_planar" with the distance of the farthest
//         point from the plane, "behind" if no pose has all points in front of the camera.
// throws  ArgumentError for lists of different length, fewer than four points, and numbers that
//         are not finite.
// source  T. Collins, A. Bartoli, Infinitesimal plane-based pose estimation, Int. J. Computer
//         Vision 109, 2014 (IPPE); refined by Gauss-Newton.
Result<PlanarPose> planar_pose(const Eigen::Matrix<double, Eigen::Dynamic, 3>& points,
                               const PlanePoints& seen);

}  // namespace armlet
