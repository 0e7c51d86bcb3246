#include "armlet/vision/solid_pose.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {

Result<FoundPose> solid_pose(const Eigen::Matrix<double, Eigen::Dynamic, 3>& points,
                             const PlanePoints& seen) {
  if (points.rows() != seen.rows() || points.rows() < 4 || points.rows() > 100'000) {
    throw ArgumentError(
        fmt::format("{} points are seen at {} pixels; expected 4 to 100000, and as many.",
                    points.rows(), seen.rows()));
  }
  if (!points.allFinite() || !seen.allFinite())
    throw ArgumentError("A point or a pixel is not finite.");
  std::vector<double> space, flat;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int k = 0; k < 3; ++k) space.push_back(points(i, k));
    for (int k = 0; k < 2; ++k) flat.push_back(seen(i, k));
  }
  checkpoint(2000 * flat.size());
  const OpencvResult found = call_opencv(
      &OpencvDoor::pose, {.numbers = {{space.data(), space.size()}, {flat.data(), flat.size()}}});
  FoundPose result;
  for (int i = 0; i < 9; ++i)
    result.T_camera_obj(i / 3, i % 3) = found.numbers[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i)
    result.T_camera_obj(i, 3) = found.numbers[static_cast<std::size_t>(9 + i)];
  double squares = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = result.T_camera_obj * Eigen::Vector3d(points.row(i).transpose());
    if (!(p.z() > 0.0)) return Error{"degenerate", "No pose has all points before the camera."};
    squares += (p.head<2>() / p.z() - seen.row(i).transpose()).squaredNorm();
  }
  result.error = std::sqrt(squares / static_cast<double>(points.rows()));
  return result;
}

}  // namespace armlet
