// The planner Fastest: one curve through all points, at each position as fast as the limits allow.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

constexpr double kSamePoint = 1e-12;  // rad or m
// The number of positions at which speeds are computed. With it the motion takes at most 0.5 %
// longer than the shortest one.
constexpr int kIntervalsPerLeg = 60;
constexpr int kFewestIntervals = 240;

// The points without repetitions of the one before.
std::vector<Eigen::VectorXd> different_points(const MoveRequest& request) {
  std::vector<Eigen::VectorXd> points = {request.q0};
  const auto add = [&](const Eigen::VectorXd& q) {
    if ((q - points.back()).cwiseAbs().maxCoeff() > kSamePoint) points.push_back(q);
  };
  for (const Eigen::VectorXd& q : request.via) add(q);
  add(request.q1);
  return points;
}

// Whether a point is on the line from a point in a direction of unit length.
bool is_on_line(const Eigen::VectorXd& p, const Eigen::VectorXd& from, const Eigen::VectorXd& way) {
  const Eigen::VectorXd off = p - from;
  return (off - way * way.dot(off)).cwiseAbs().maxCoeff() <= kSamePoint;
}

// The points through which the path is made. Where all joints move in proportion the path is
// straight, so only the first and the last point and those at which it reverses are needed. A
// spline through all points would overshoot these, and would become very slow where points are
// close to each other. Otherwise one piece has all points.
std::vector<std::vector<Eigen::VectorXd>> pieces_of(const std::vector<Eigen::VectorXd>& points) {
  const Eigen::VectorXd& from = points.front();
  const auto far = std::ranges::max_element(
      points, {}, [&](const Eigen::VectorXd& p) { return (p - from).squaredNorm(); });
  const Eigen::VectorXd way = (*far - from).normalized();
  for (const Eigen::VectorXd& p : points) {
    if (!is_on_line(p, from, way)) return {points};
  }
  std::vector<std::vector<Eigen::VectorXd>> pieces = {{from, points[1]}};
  for (std::size_t k = 2; k < points.size(); ++k) {
    const Eigen::VectorXd last = pieces.back()[1];
    if ((points[k] - last).dot(last - pieces.back()[0]) > 0.0)
      pieces.back()[1] = points[k];
    else
      pieces.push_back({last, points[k]});
  }
  return pieces;
}

// Empty if the motors cannot hold the arm at some position.
std::optional<Trajectory> run_fastest(const MoveRequest& request,
                                      const std::vector<Eigen::VectorXd>& points,
                                      std::span<const AxisLimits> limits, bool by_motors) {
  std::optional<Trajectory> whole;
  for (const std::vector<Eigen::VectorXd>& piece : pieces_of(points)) {
    const int intervals =
        std::max(kFewestIntervals, kIntervalsPerLeg * static_cast<int>(piece.size() - 1));
    const Trajectory path = path_through(piece);
    std::optional<Trajectory> run =
        by_motors ? time_optimal_with_motors(*request.motors, path, limits, intervals)
                  : time_optimal(path, limits, intervals);
    if (!run) return {};
    whole = whole ? whole->then(*run) : std::move(run);
  }
  return whole;
}

}  // namespace

Plan plan_fastest(const MoveRequest& request) {
  if (!request.durations.empty()) {
    throw ArgumentError(
        "The planner Fastest divides the time among the legs by itself; leave durations out.");
  }
  const std::vector<Eigen::VectorXd> points = different_points(request);
  if (points.size() < 2)
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  std::vector<AxisLimits> limits = limits_beside_motors(request);
  std::optional<Trajectory> strongest;
  if (request.motors != nullptr) strongest = run_fastest(request, points, limits, true);
  // If the motors cannot hold the arm, the motion is planned with acceleration limits, so that the
  // verification reports by how much the motors are too weak.
  if (!strongest) limits = request.limits;
  const Trajectory fastest =
      strongest ? *std::move(strongest) : *run_fastest(request, points, limits, false);
  const Duration chosen =
      choose_duration(request, tightest_joint(request, limits, fastest, Jerk::kFree));
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  return {.trajectory = fastest.stretched(chosen.T / fastest.duration()),
          .too_fast = chosen.too_fast};
}

}  // namespace armlet
