// Checks of the arguments of a servo loop, and explanations of its end.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/camera/visual_servo.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kPoor = 1e-3;  // of singular values of L, in normalised coordinates

// An orthonormal basis of the range of A.
MatrixXd reach_of(const MatrixXd& A) {
  constexpr double kRank = 1e-8;
  const SvdParts parts = singular_values(A);
  return parts.U.leftCols(rank_above(A, kRank));
}

// "move the camera along its x axis or rotate it about its y axis": the motions that the joints
// cannot give the camera.
std::string lacking_axes(const MatrixXd& J) {
  constexpr double kNearlyAll = 0.99;
  const MatrixXd reach = reach_of(J);
  std::string out;
  for (Index i = 0; i < 6; ++i) {
    const double given = reach.row(i).squaredNorm();
    if (1.0 - given < kNearlyAll * kNearlyAll) continue;
    out +=
        fmt::format("{}{} {} {} its {} axis", out.empty() ? "" : " or ", i < 3 ? "move" : "rotate",
                    out.empty() ? "the camera" : "it", i < 3 ? "along" : "about", "xyz"[i % 3]);
  }
  return out;
}

// "0.50"; "0.00" for values below rounding.
std::string share_text(double value) {
  constexpr double kRounded = 0.005;
  return fmt::format("{:.2f}", std::abs(value) < kRounded ? 0.0 : value);
}

}  // namespace

std::string_view name_of(ServoEnd end) {
  constexpr std::string_view kNames[] = {
      "",         "Converged",  "Timeout",    "FeatureLost", "LocalMinimum",
      "Singular", "JointLimit", "OutOfImage", "Stopped"};
  return kNames[static_cast<std::size_t>(end)];
}

void VisualServo::check_goal() {
  const Index k = goal_.wanted.rows();
  if (k < 4 || k > kMostServoPoints)
    throw ArgumentError(
        fmt::format("{} points are wanted; expected 4 to {}.", k, kMostServoPoints));
  check_finite("wanted", goal_.wanted);
  const Intrinsics& of = lens_.intrinsics();
  for (Index i = 0; i < k; ++i) {
    if (lens_.is_inside(goal_.wanted.row(i).transpose())) continue;
    throw ArgumentError(
        fmt::format("Point {} is wanted at ({:g}, {:g}), outside of the picture of {} x {}.", i,
                    goal_.wanted(i, 0), goal_.wanted(i, 1), of.width, of.height));
  }
  if (goal_.depths.size() > 1 && goal_.depths.size() != k) {
    throw ArgumentError(fmt::format("There are {} depths for {} points; expected one or as many.",
                                    goal_.depths.size(), k));
  }
  for (const double depth : goal_.depths) check_positive("depth", depth);
  if (goal_.points.rows() != 0 && goal_.points.rows() != k) {
    throw ArgumentError(
        fmt::format("{} points of the object are given and {} are wanted in the picture.",
                    goal_.points.rows(), k));
  }
  if (goal_.points.rows() == 0 && !is_image_law())
    throw ArgumentError("The laws \"position\" and \"hybrid\" need the points of the object.");
  if (goal_.points.rows() == 0 && goal_.depths.size() == 0)
    throw ArgumentError("Neither the depth of the points is given, nor the points of the object.");
}

void VisualServo::check_options() const {
  check_positive("period", options_.period);
  check_positive("within", options_.within);
  check_positive("timeout", options_.timeout);
  if (options_.patience < 0)
    throw ArgumentError(fmt::format("`patience` is {}; expected 0 or more.", options_.patience));
  if (!(options_.smooth >= 0.0) || !std::isfinite(options_.smooth))
    throw ArgumentError(fmt::format("`smooth` is {}; expected 0 or more.", options_.smooth));
  const double fastest = options_.gain.at(0.0);
  if (fastest * options_.period >= 2.0) {
    throw ArgumentError(
        fmt::format("A gain of {:g} 1/s with a period of {:g} s does not settle: their product is "
                    "{:g}, and has to "
                    "be below 2, better below 1.",
                    fastest, options_.period, fastest * options_.period));
  }
}

void VisualServo::check_sight(const ServoSight& sight) const {
  const Index n = arm_.lower.size();
  const Index k = goal_.wanted.rows();
  if (sight.J_camera.rows() != 6 || sight.J_camera.cols() != n || sight.q.size() != n ||
      sight.qd.size() != n) {
    throw ArgumentError(fmt::format(
        "J_camera is {} x {} and q and qd have {} and {} values for {} joints.",
        sight.J_camera.rows(), sight.J_camera.cols(), sight.q.size(), sight.qd.size(), n));
  }
  check_finite("J_camera", sight.J_camera);
  check_finite("q", sight.q);
  check_finite("qd", sight.qd);
  if (sight.pixels) {
    if (sight.pixels->rows() != k)
      throw ArgumentError(
          fmt::format("{} points are seen and {} are wanted.", sight.pixels->rows(), k));
    check_finite("pixels", *sight.pixels);
  }
  for (const Index i : sight.missing) {
    if (sight.pixels && i >= 0 && i < k) continue;
    throw ArgumentError(fmt::format("Point {} is missing of {} that are seen.", i,
                                    sight.pixels ? sight.pixels->rows() : 0));
  }
  if (sight.depths.size() != 0) {
    if (sight.depths.size() != k)
      throw ArgumentError(
          fmt::format("There are {} depths for {} points.", sight.depths.size(), k));
    check_finite("depths", sight.depths);
  }
}

MatrixXd VisualServo::uncontrollable() const {
  if (pixel_L_.size() == 0) return MatrixXd(2 * goal_.wanted.rows(), 0);
  const MatrixXd free = reach_of(pixel_L_);
  const MatrixXd arm = reach_of(pixel_L_ * J_camera_);
  const SvdParts rest = singular_values(free - arm * (arm.transpose() * free));
  return rest.U.leftCols(std::max<Index>(0, free.cols() - arm.cols()));
}

std::string VisualServo::explanation() const {
  const Index k = goal_.wanted.rows();
  std::string out = fmt::format("{}: {}.", name_of(end_), why_);
  if (rows_.empty() || pixel_L_.size() == 0) return out;
  const ServoRow& last = rows_.back();
  out += fmt::format(" The loop took {} picture{} in {:g} s.", rows_.size(),
                     rows_.size() == 1 ? "" : "s", last.t);
  const MatrixXd blind = uncontrollable();
  const Index free = reach_of(pixel_L_).cols();
  out += fmt::format(
      "\nThe picture of {} points has {} coordinates. A camera that moves freely changes them in "
      "{} directions, this arm in {} (rank of L J).",
      k, 2 * k, free, free - blind.cols());
  if (const std::string lacking = lacking_axes(J_camera_); !lacking.empty())
    out += fmt::format("\nThe joints cannot {}.", lacking);
  const Eigen::Map<const VectorXd> at(last.points.data(), 2 * k), goal(goal_.wanted.data(), 2 * k);
  const VectorXd error = at - goal;
  for (Index d = 0; d < blind.cols(); ++d) {
    out +=
        fmt::format("\nThis arm does not control the direction with {:.1f} px of the last error:",
                    std::abs(blind.col(d).dot(error)));
    for (Index i = 0; i < std::min<Index>(k, 8); ++i)
      out += fmt::format("{} point {} ({}, {})", i == 0 ? "" : ",", i, share_text(blind(2 * i, d)),
                         share_text(blind(2 * i + 1, d)));
    if (k > 8) out += ", ...";
  }
  const auto worst = std::ranges::min_element(rows_, {}, &ServoRow::smallest);
  out += fmt::format(
      "\nThe smallest singular value of L is {:.3g} in the last picture; its minimum is {:.3g}, at "
      "{:g} s.",
      last.smallest, worst->smallest, worst->t);
  if (worst->smallest < kPoor)
    out += fmt::format(" Below {:g}, small errors in the picture cause large motions.", kPoor);
  return out;
}

}  // namespace armlet
