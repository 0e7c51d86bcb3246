#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// kStandard  A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i); joint i moves about z of frame i-1.
// kModified  A_i = Rx(alpha_i) Tx(a_i) Rz(theta_i) Tz(d_i); row i stores alpha_{i-1} and a_{i-1},
//            and joint i moves about z of frame i.
// source     R. Paul, Robot Manipulators, 1981 (standard); J. J. Craig, Introduction to Robotics,
//            2005, chapter 3 (modified).
enum class DhConvention { kStandard, kModified };

// One Denavit-Hartenberg row, m and rad. The joint's value is added to theta (revolute) or to d
// (prismatic), so that entry is the zero offset.
struct DhRow {
  double theta = 0.0;
  double d = 0.0;
  double a = 0.0;
  double alpha = 0.0;
};

// Pose of frame i in frame i-1 for a row whose theta and d already include the joint's value.
Eigen::Isometry3d dh_pose(DhConvention convention, const DhRow& row);

// Sine and cosine of a link twist, rad; results within 1e-12 of 0, 1 or -1 are made exact, because
// tables give rounded multiples of a right angle.
struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};
SinCos snapped_sin_cos(double angle);

// No function of this header throws.

// An arm in the modified convention: modified rows, and a pose to put before the tool.
struct ModifiedDh {
  std::vector<DhRow> rows;
  Eigen::Isometry3d T_last_flange = Eigen::Isometry3d::Identity();
};
ModifiedDh to_modified(const std::vector<DhRow>& standard_rows);

}  // namespace armlet
