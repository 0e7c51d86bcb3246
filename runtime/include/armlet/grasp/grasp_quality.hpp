// The quality of a grasp: the ball of Ferrari and Canny, the grasp matrix, and the load that
// contacts carry.
#pragma once

#include <Eigen/Core>
#include <span>

#include "armlet/math/twist.hpp"

namespace armlet {

// A finger that presses on a body at a point, with friction and without a moment of its own.
//
// p         position, m.
// inward    unit vector into the body.
// friction  coefficient of Coulomb friction, >= 0.
struct GraspContact {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d inward = Eigen::Vector3d::UnitX();
  double friction = 0.0;
};

// Friction cones are approximated by inscribed pyramids with this many edges. The radius of the
// ball is at most 1 - cos(pi / 12), 3.4 %, too small because of that, and never too large.
inline constexpr int kConeEdges = 12;

// epsilon       radius of the largest ball about the origin in the convex hull of the wrenches that
//               single contacts exert with a normal force of 1 N: every load of that size, in any
//               direction, can be held with normal forces of 1 N in all. Without a unit: moments
//               are divided by a length.
// min_singular  the smallest singular value of the grasp matrix, which maps the forces at the
//               contacts to the wrench on the body, moments scaled in the same way.
// force_closure  epsilon is above 0: the contacts withstand any load if their forces are large
//                enough.
struct GraspQuality {
  double epsilon = 0.0;
  double min_singular = 0.0;
  int contacts = 0;
  bool force_closure = false;
};

// center   reference point of moments, m: the centre of mass.
// scale    length that moments are divided by, m, > 0: the largest distance of the surface from it.
// throws   ArgumentError for an impossible scale, friction, point or normal.
// source   C. Ferrari, J. Canny, Planning optimal grasps, IEEE Int. Conf. on Robotics and
//          Automation, 1992 (the sum of the normal forces is limited); Z. Li, S. S. Sastry,
//          Task-oriented optimal grasping by multifingered robot hands, IEEE J. Robotics and
//          Automation 4, 1988 (singular values); A. T. Miller, P. K. Allen, Examples of 3D grasp
//          quality computations, ICRA 1999 (moments divided by the largest radius).
GraspQuality grasp_quality(std::span<const GraspContact> contacts, const Eigen::Vector3d& center,
                           double scale);

// The quality of a grasp for a body in the plane z = 0: forces along x and y, moments about z, and
// friction in the plane alone, where the cone is exact.
GraspQuality planar_grasp_quality(std::span<const GraspContact> contacts,
                                  const Eigen::Vector2d& center, double scale);

// The part of a load that contacts withstand with normal forces of at most `presses[i]`, N, each,
// and their friction. 1 or more: they hold it; values above 1000 are returned as 1000.
//
// load    [f; m] on the body, m about `center`, N and N m.
// throws  ArgumentError as above, and unless there is one normal force >= 0 for each contact.
double load_factor(std::span<const GraspContact> contacts, std::span<const double> presses,
                   const Eigen::Vector3d& center, double scale, const Vector6d& load);

// Radius of the largest ball about the origin in the convex hull of the columns; 0 if the origin is
// not inside, or the hull is flat. Exact to 1e-6 of the longest column.
double ball_in_hull(const Eigen::MatrixXd& points);

}  // namespace armlet
