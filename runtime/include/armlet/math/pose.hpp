#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>

#include "armlet/math/twist.hpp"

namespace armlet {

// Positions are in m and angles in rad. Functions of poses assume orthonormal rotations and do not
// throw; check_pose is for poses from outside.

// T_a_b maps coordinates from b to a, so frames cancel: T_a_c = T_a_b T_b_c.
Eigen::Isometry3d make_pose(const Eigen::Matrix3d& R, const Eigen::Vector3d& p);
Eigen::Isometry3d make_translation(const Eigen::Vector3d& p);

// Position p and fixed-axis roll, pitch, yaw: R = Rz(yaw) Ry(pitch) Rx(roll), rad.
Eigen::Isometry3d pose_from_rpy(const Eigen::Vector3d& p, const Eigen::Vector3d& rpy);

// Difference of two poses given in one frame: [p_to - p_from; log(R_to R_from^T)], m and rad.
Vector6d pose_error(const Eigen::Isometry3d& T_from, const Eigen::Isometry3d& T_to);

// Angle of the rotation between two poses, rad, in [0, pi].
double angle_between(const Eigen::Isometry3d& T_1, const Eigen::Isometry3d& T_2);

// Exponential and logarithm of SE(3), xi = [rho; phi]: exp = [exp(phi), V(phi) rho].
// The logarithm is exact for every angle up to and including pi.
// source  R. Murray, Z. Li, S. Sastry, A Mathematical Introduction to Robotic Manipulation, 1994,
//         chapter 2 (exponential coordinates for rigid motion).
Eigen::Isometry3d pose_exp(const Vector6d& xi);
Vector6d pose_log(const Eigen::Isometry3d& T);

// Interpolation between two poses: the position on the straight line, the rotation at constant
// angular velocity about a fixed axis (slerp).
//
// s  0 gives T_0, 1 gives T_1; other values extrapolate.
Eigen::Isometry3d interpolate(const Eigen::Isometry3d& T_0, const Eigen::Isometry3d& T_1, double s);

// Screw motion T_0 exp(s log(T_0^-1 T_1)): the origin follows a helix. s as above.
Eigen::Isometry3d interpolate_screw(const Eigen::Isometry3d& T_0, const Eigen::Isometry3d& T_1,
                                    double s);

// The pose with its rotation made orthonormal again; for use after many products.
Eigen::Isometry3d renormalised(const Eigen::Isometry3d& T);

// True if R^T R = I within tolerance, element by element, and det R > 0.
bool is_rotation(const Eigen::Matrix3d& R, double tolerance = 1e-6);

// Throws ArgumentError if T has elements that are not finite or a part that is not a rotation.
void check_pose(std::string_view name, const Eigen::Isometry3d& T);

// "(180, -264.2, 20) mm, rpy (180, 0, 90) deg"
std::string format_pose(const Eigen::Isometry3d& T);

}  // namespace armlet
