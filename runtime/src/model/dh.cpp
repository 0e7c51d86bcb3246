#include "armlet/model/dh.hpp"

#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

double snapped(double x) {
  const double nearest = x > 0.5 ? 1.0 : (x < -0.5 ? -1.0 : 0.0);
  return std::abs(x - nearest) < 1e-12 ? nearest : x;
}

// Returns Rx(alpha) Tx(a).
Eigen::Isometry3d x_part(const DhRow& row) {
  const SinCos alpha = snapped_sin_cos(row.alpha);
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, alpha.cos, -alpha.sin, 0, alpha.sin, alpha.cos;
  return make_pose(R, {row.a, 0.0, 0.0});
}

// Returns Rz(theta) Tz(d).
Eigen::Isometry3d z_part(const DhRow& row) {
  return make_pose(rot_z(row.theta), {0.0, 0.0, row.d});
}

}  // namespace

Eigen::Isometry3d dh_pose(DhConvention convention, const DhRow& row) {
  return convention == DhConvention::kStandard ? z_part(row) * x_part(row)
                                               : x_part(row) * z_part(row);
}

SinCos snapped_sin_cos(double angle) {
  const det::SinCos sc = det::sincos(angle);
  return {snapped(sc.sin), snapped(sc.cos)};
}

ModifiedDh to_modified(const std::vector<DhRow>& standard_rows) {
  ModifiedDh result;
  DhRow previous;
  for (const DhRow& row : standard_rows) {
    result.rows.push_back({row.theta, row.d, previous.a, previous.alpha});
    previous = row;
  }
  result.T_last_flange = x_part(previous);
  return result;
}

}  // namespace armlet
