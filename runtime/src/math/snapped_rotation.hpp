#pragma once

#include <Eigen/Core>
#include <cmath>

namespace armlet {

// Replaces entries that are rounding errors of a right angle by zero, if the other entries form a
// rotation without them.
inline Eigen::Matrix3d snapped(const Eigen::Matrix3d& R) {
  constexpr double kRightAngle = 1e-5;
  Eigen::Matrix3d S = R;
  for (double& entry : S.reshaped()) {
    if (std::abs(entry) < kRightAngle) entry = 0.0;
  }
  if (S == R) return R;
  for (Eigen::Index k = 0; k < 3; ++k) S.col(k) /= S.col(k).norm();
  const Eigen::Matrix3d gram = S.transpose() * S;
  if ((gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > 1e-9) return R;
  return 0.5 * S * (3.0 * Eigen::Matrix3d::Identity() - gram);
}

}  // namespace armlet
