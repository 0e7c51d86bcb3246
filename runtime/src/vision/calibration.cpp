#include "armlet/vision/calibration.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/checkpoint.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

constexpr std::size_t kLensNumbers = 19;  // before the poses of the views
constexpr std::size_t kPoseNumbers = 12;

void append_pose(const Eigen::Isometry3d& T, std::vector<double>& numbers) {
  for (int i = 0; i < 9; ++i) numbers.push_back(T(i / 3, i % 3));
  for (int i = 0; i < 3; ++i) numbers.push_back(T(i, 3));
}

Eigen::Isometry3d pose_in(const double* numbers) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 9; ++i) T(i / 3, i % 3) = numbers[i];
  for (int i = 0; i < 3; ++i) T(i, 3) = numbers[9 + i];
  return T;
}

DoorNumbers door_numbers(const std::vector<double>& numbers) {
  return {numbers.data(), numbers.size()};
}

void check_views(std::span<const PlanePoints> views,
                 const Eigen::Matrix<double, Eigen::Dynamic, 3>& points) {
  if (views.size() < 3 || views.size() > 30)
    throw ArgumentError(fmt::format("There are {} views; expected 3 to 30.", views.size()));
  if (points.rows() < 4 || points.rows() * static_cast<Eigen::Index>(views.size()) > 2'000) {
    throw ArgumentError(
        fmt::format("The pattern has {} points; expected 4 or more, and at most 2000 in all views.",
                    points.rows()));
  }
  if (!points.allFinite() || points.col(2).cwiseAbs().maxCoeff() > 0.0)
    throw ArgumentError("The points of the pattern are finite and have z = 0.");
  const Eigen::Matrix<double, Eigen::Dynamic, 2> flat =
      points.leftCols<2>().rowwise() - points.leftCols<2>().colwise().mean();
  const Eigen::Vector2d spread = (flat.transpose() * flat).jacobiSvd().singularValues();
  if (!(spread[1] > 1e-8 * spread[0]))
    throw ArgumentError("The points of the pattern are on a line.");
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].rows() != points.rows()) {
      throw ArgumentError(fmt::format("View {} has {} points, and the pattern {}.", i,
                                      views[i].rows(), points.rows()));
    }
    if (!views[i].allFinite() || views[i].cwiseAbs().maxCoeff() > 1e6)
      throw ArgumentError(fmt::format("A pixel of view {} is not in any picture.", i));
  }
}

// The largest angle between the normals of a target in two views.
double spread_of_views(const std::vector<Eigen::Isometry3d>& T_camera_target) {
  double largest = 0.0;
  for (const auto& a : T_camera_target) {
    for (const auto& b : T_camera_target) {
      const double c = a.linear().col(2).dot(b.linear().col(2));
      largest = std::max(largest, std::acos(std::clamp(c, -1.0, 1.0)));
    }
  }
  return largest;
}

}  // namespace

Result<CameraCalibration> calibrate_camera(std::span<const PlanePoints> views,
                                           const Eigen::Matrix<double, Eigen::Dynamic, 3>& points,
                                           int width, int height, int terms) {
  check_views(views, points);
  if (width < 1 || height < 1 || width > Image::kMostSide || height > Image::kMostSide)
    throw ArgumentError(fmt::format("A picture of {} x {} pixels is none.", width, height));
  if (terms < 0 || terms > 5 || terms == 3) {
    throw ArgumentError(fmt::format(
        "{} terms of distortion; expected 0, 1, 2, 4 or 5 of k1, k2, p1, p2, k3.", terms));
  }
  std::vector<double> space, seen, counts;
  for (const PlanePoints& view : views) {
    for (Eigen::Index i = 0; i < view.rows(); ++i) {
      for (int k = 0; k < 3; ++k) space.push_back(points(i, k));
      for (int k = 0; k < 2; ++k) seen.push_back(view(i, k));
    }
    counts.push_back(static_cast<double>(view.rows()));
  }
  checkpoint(20'000 * counts.size() * (counts.size() + static_cast<std::size_t>(points.rows())));
  const OpencvResult found = call_opencv(
      &OpencvDoor::calibrate,
      {.numbers = {door_numbers(space), door_numbers(seen), door_numbers(counts)}},
      {static_cast<double>(width), static_cast<double>(height), static_cast<double>(terms)});
  const double* n = found.numbers.data();
  if (!std::all_of(found.numbers.begin(), found.numbers.end(),
                   [](double v) { return std::isfinite(v); }) ||
      n[0] <= 0.0 || n[1] <= 0.0)
    return Error{"degenerate", "No lens explains these views."};
  CameraCalibration result{.lens = {n[0], n[1], n[2], n[3], {}}, .error = n[9]};
  std::copy_n(n + 4, 5, result.lens.distortion.begin());
  std::copy_n(n + 10, 9, result.deviation.begin());
  for (std::size_t i = kLensNumbers; i + kPoseNumbers <= found.numbers.size(); i += kPoseNumbers)
    result.T_camera_target.push_back(pose_in(n + i));
  const double spread = spread_of_views(result.T_camera_target) * 180.0 / std::numbers::pi;
  if (spread < 5.0) {
    return Error{"degenerate",
                 fmt::format("The pattern is inclined by {:.1f} deg at most from view to view; a "
                             "lens shows from 5 deg on, well from 30 deg on.",
                             spread)};
  }
  return result;
}

// ---- pose of the camera on the tool

namespace {

// The largest angle between the axes of two rotations of the tool by at least a degree, rad;
// negative if there are no two such rotations.
double spread_of_axes(std::span<const Eigen::Isometry3d> T_world_tool) {
  constexpr double kLeast = 0.017;
  std::vector<Eigen::Vector3d> axes;
  for (std::size_t i = 1; i < T_world_tool.size(); ++i) {
    const Eigen::AngleAxisd r(T_world_tool[0].linear().transpose() * T_world_tool[i].linear());
    if (std::abs(r.angle()) > kLeast) axes.push_back(r.axis());
  }
  double largest = -1.0;
  for (const auto& a : axes)
    for (const auto& b : axes) largest = std::max(largest, a.cross(b).norm());
  return largest < 0.0 ? largest : std::asin(std::min(1.0, largest));
}

// Root of the mean square distance of the target from its mean pose.
void measure_spread(std::span<const Eigen::Isometry3d> T_world_tool,
                    std::span<const Eigen::Isometry3d> T_camera_target, HandEye& found) {
  const auto count = static_cast<double>(T_world_tool.size());
  std::vector<Eigen::Isometry3d> targets;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < T_world_tool.size(); ++i) {
    targets.push_back(T_world_tool[i] * found.T_tool_camera * T_camera_target[i]);
    middle += targets.back().translation() / count;
    sum += targets.back().linear();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d mean = svd.matrixU() * svd.matrixV().transpose();
  double squares = 0.0, angles = 0.0;
  for (const Eigen::Isometry3d& T : targets) {
    squares += (T.translation() - middle).squaredNorm();
    const double angle = Eigen::AngleAxisd(mean.transpose() * T.linear()).angle();
    angles += angle * angle;
  }
  found.error = std::sqrt(squares / count);
  found.tilt = std::sqrt(angles / count);
}

}  // namespace

Result<HandEye> hand_eye(std::span<const Eigen::Isometry3d> T_world_tool,
                         std::span<const Eigen::Isometry3d> T_camera_target, HandEyeMethod method) {
  if (T_world_tool.size() != T_camera_target.size()) {
    throw ArgumentError(fmt::format("{} poses of the tool and {} of the target.",
                                    T_world_tool.size(), T_camera_target.size()));
  }
  if (T_world_tool.size() < 3 || T_world_tool.size() > 100) {
    throw ArgumentError(
        fmt::format("There are {} stations; expected 3 to 100.", T_world_tool.size()));
  }
  std::vector<double> tools, targets;
  for (std::size_t i = 0; i < T_world_tool.size(); ++i) {
    append_pose(T_world_tool[i], tools);
    append_pose(T_camera_target[i], targets);
  }
  const auto is_finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(tools.begin(), tools.end(), is_finite) ||
      !std::all_of(targets.begin(), targets.end(), is_finite))
    throw ArgumentError("A pose has a number that is not finite.");
  const double spread = spread_of_axes(T_world_tool) * 180.0 / std::numbers::pi;
  if (spread < 5.0) {
    return Error{"degenerate",
                 "The tool has to rotate about two axes that differ by 5 deg or more between the "
                 "stations; " +
                     (spread < 0.0 ? std::string("it did not rotate.")
                                   : fmt::format("they differ by {:.1f} deg.", spread))};
  }
  checkpoint(1000 * tools.size() * tools.size() / kPoseNumbers);
  const OpencvResult found =
      call_opencv(&OpencvDoor::hand_eye, {.numbers = {door_numbers(tools), door_numbers(targets)}},
                  {static_cast<double>(method)});
  if (!std::all_of(found.numbers.begin(), found.numbers.end(), is_finite))
    return Error{"degenerate", "No pose of the camera on the tool explains these stations."};
  HandEye result{.T_tool_camera = pose_in(found.numbers.data())};
  measure_spread(T_world_tool, T_camera_target, result);
  return result;
}

Image undistorted(const Image& image, const LensNumbers& lens) {
  check_door_picture("undistort", image, false);
  const auto& d = lens.distortion;
  const double numbers[] = {lens.fx, lens.fy, lens.cx, lens.cy, d[0], d[1], d[2], d[3], d[4]};
  if (!std::all_of(std::begin(numbers), std::end(numbers),
                   [](double v) { return std::isfinite(v); }) ||
      lens.fx <= 0.0 || lens.fy <= 0.0)
    throw ArgumentError("A lens has finite numbers and focal lengths above 0.");
  return call_opencv(&OpencvDoor::undistort, {.picture = door_picture(image)},
                     {lens.fx, lens.fy, lens.cx, lens.cy, d[0], d[1], d[2], d[3], d[4]})
      .picture;
}

}  // namespace armlet
