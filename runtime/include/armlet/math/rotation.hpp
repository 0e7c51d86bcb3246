#pragma once

#include <Eigen/Geometry>
#include <string_view>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Angles are in rad. Functions of rotations assume orthonormal matrices; functions that throw say
// so.

// Elementary rotations about one axis.
Eigen::Matrix3d rot_x(double angle);
Eigen::Matrix3d rot_y(double angle);
Eigen::Matrix3d rot_z(double angle);

// Roll, pitch, yaw about the fixed axes X, then Y, then Z: R = Rz(yaw) Ry(pitch) Rx(roll).
//
// rpy_from_R returns the pitch in [-pi/2, pi/2]; at a pitch of a right angle, where only yaw - roll
// or yaw + roll is defined, the roll is zero.
Eigen::Matrix3d R_from_rpy(const Eigen::Vector3d& rpy);
Eigen::Vector3d rpy_from_R(const Eigen::Matrix3d& R);

// Euler angles about moving axes named by a sequence such as "ZYZ" or "XYZ": the product of the
// three elementary rotations in that order.
//
// euler_from_R returns the second angle in [0, pi] for sequences like ZYZ and in [-pi/2, pi/2] for
// sequences like XYZ; where the first and third axes coincide, the first angle is zero.
// throws  ArgumentError if the sequence is not three letters X, Y, Z with unequal neighbours.
Eigen::Matrix3d R_from_euler(std::string_view sequence, const Eigen::Vector3d& angles);
Eigen::Vector3d euler_from_R(std::string_view sequence, const Eigen::Matrix3d& R);

// Whether only the sum or difference of the first and the third angle of the sequence is defined:
// the sine (ZYZ) or cosine (XYZ) of the second angle is below 1e-9, and euler_from_R returns 0 as
// the first angle.
bool is_euler_singular(std::string_view sequence, const Eigen::Matrix3d& R);

// Rotation by an angle about an axis, which need not be a unit vector.
//
// throws  ArgumentError if the axis has no direction.
Eigen::Matrix3d R_from_axis_angle(const Eigen::Vector3d& axis, double angle);

// Exponential and logarithm of SO(3): a rotation vector is axis times angle, rad.
//
// rotation_log has an angle in [0, pi] and is exact up to pi, where the sign of the axis is chosen
// so that its first component that is not zero is positive.
// source  S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1(3), 1978.
Eigen::Matrix3d rotation_exp(const Eigen::Vector3d& phi);
Eigen::Vector3d rotation_log(const Eigen::Matrix3d& R);

// Unit vector along rotation_log(R); the z axis if R is the identity.
Eigen::Vector3d axis_of_rotation(const Eigen::Matrix3d& R);

// Unit quaternions as (w, x, y, z), Hamilton's convention. quaternion_from_R returns w >= 0.
//
// throws  ArgumentError if a quaternion has no direction; its length does not matter.
Eigen::Vector4d quaternion_from_R(const Eigen::Matrix3d& R);
Eigen::Matrix3d R_from_quaternion(const Eigen::Vector4d& wxyz);

// Angle of the rotation R_1^T R_2, rad, in [0, pi].
double angle_between(const Eigen::Matrix3d& R_1, const Eigen::Matrix3d& R_2);

// The rotation between two rotations at constant angular velocity about a fixed axis (slerp).
Eigen::Matrix3d interpolate(const Eigen::Matrix3d& R_0, const Eigen::Matrix3d& R_1, double s);

// The rotation nearest to a matrix that is no longer orthonormal because of rounding.
Eigen::Matrix3d renormalised(const Eigen::Matrix3d& R);

}  // namespace armlet
