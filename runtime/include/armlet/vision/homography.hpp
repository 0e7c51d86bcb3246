#pragma once
// Two pictures of a plane, or a plane and its picture.

#include <Eigen/Core>

#include "armlet/core/error.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// The projective map from the points `from` to the points `to`, by the least squares of its linear
// equations after both lists have been centred and scaled.
//
// from, to  n x 2, n >= 4, in the same order; any unit.
// returns   H, 3 x 3, H(2, 2) = 1 where that is possible and a norm of 1 otherwise; the error
//           "degenerate" if the points do not determine it: all but one lie on a line, or coincide.
// throws    ArgumentError for lists of different length, fewer than four points, and numbers that
//           are not finite.
// source    R. Hartley, In defense of the eight-point algorithm, IEEE Trans. PAMI 19(6), 1997;
//           R. Hartley, A. Zisserman, Multiple View Geometry, 2nd ed., 2004, algorithm 4.2.
Result<Eigen::Matrix3d> homography(const PlanePoints& from, const PlanePoints& to);

// The images of points under H, n x 2.
//
// throws  ArgumentError that names the first point whose image is at infinity.
PlanePoints map_points(const Eigen::Matrix3d& H, const PlanePoints& points);

}  // namespace armlet
