#include "armlet/trajectory/cartesian_spline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/trajectory/spline.hpp"
#include "trajectory/tool/curve_plan.hpp"
#include "trajectory/tool/line_samples.hpp"

namespace armlet {
namespace {

constexpr double kNoLength = 1e-9;     // m
constexpr int kLengthIntervals = 256;  // for the length of the curve

// The rotation vector with the same rotation as w that is nearest to `before`.
Eigen::Vector3d without_jump(const Eigen::Vector3d& w, const Eigen::Vector3d& before) {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  const double angle = w.norm();
  const Eigen::Vector3d along = angle > 1e-9          ? Eigen::Vector3d(w / angle)
                                : before.norm() > 0.0 ? Eigen::Vector3d(before.normalized())
                                                      : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  const double turns = std::round((before.dot(along) - angle) / kRevolution);
  return (angle + kRevolution * turns) * along;
}

std::vector<Segment> pieces_of(SplineKind kind, const std::vector<double>& t,
                               const std::vector<double>& x) {
  switch (kind) {
    case SplineKind::kCubic:
      return cubic_interpolator(t, x);
    case SplineKind::kSpline4:
      return quartic_spline(t, x);
    case SplineKind::kSpline5:
      return quintic_spline(t, x);
    default:
      return cubic_spline(t, x);
  }
}

// The poses of the curve, the present tool pose first, each with its time.
struct Knots {
  std::vector<Eigen::Isometry3d> poses{};
  std::vector<int> indices{};   // of the poses in the move
  std::vector<double> times{};  // from 0 to 1
};

Knots knots_of(const Robot& robot, const SplineMove& move) {
  Knots knots{.poses = {forward(robot, move.q0)}, .indices = {-1}, .times = {0.0}};
  for (std::size_t k = 0; k < move.poses.size(); ++k) {
    const CurvePiece leg = straight_piece(knots.poses.back(), move.poses[k]);
    const double length = move.task == IkTask::kPositionFirst ? leg.travel() : leg.length;
    if (length <= kNoLength) continue;
    knots.poses.push_back(move.poses[k]);
    knots.indices.push_back(static_cast<int>(k));
    knots.times.push_back(knots.times.back() + length);
  }
  const double whole = knots.times.back();
  for (double& t : knots.times) t = whole > 0.0 ? t / whole : 0.0;
  knots.times.back() = whole > 0.0 ? 1.0 : 0.0;
  return knots;
}

CurveSpline spline_through(const Knots& knots, SplineKind kind) {
  CurveSpline curve{.T_start = knots.poses[0]};
  std::array<std::vector<double>, 6> x;
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
  for (const Eigen::Isometry3d& T : knots.poses) {
    const Eigen::Vector3d position = T.translation() - curve.T_start.translation();
    rotation =
        without_jump(rotation_log(curve.T_start.linear().transpose() * T.linear()), rotation);
    for (int i = 0; i < 3; ++i) {
      x[static_cast<std::size_t>(i)].push_back(position[i]);
      x[static_cast<std::size_t>(i + 3)].push_back(rotation[i]);
    }
  }
  for (std::size_t i = 0; i < 6; ++i) curve.x[i] = pieces_of(kind, knots.times, x[i]);
  return curve;
}

void check_move(const Robot& robot, const SplineMove& move) {
  if (move.poses.empty()) throw ArgumentError("A curve needs at least one place.");
  for (const Eigen::Isometry3d& T : move.poses) check_pose("poses", T);
  check_line_move(
      robot,
      {.q0 = move.q0, .T_world_goal = move.poses.back(), .time = move.time, .speed = move.speed});
}

// Sets the fault: the leg in which the curve cannot be followed, and the fraction of it.
void blame(PathPlan& plan, const Knots& knots, LineFault fault) {
  std::size_t k = 1;
  while (k + 1 < knots.times.size() && knots.times[k] <= fault.fraction) ++k;
  const double leg = knots.times[k] - knots.times[k - 1];
  fault.fraction = std::clamp((fault.fraction - knots.times[k - 1]) / leg, 0.0, 1.0);
  plan.fault = std::move(fault);
  plan.point = knots.indices[k];
}

}  // namespace

PathPlan plan_cartesian_spline(const Robot& robot, const SplineMove& move) {
  check_move(robot, move);
  PathPlan plan;
  const Knots knots = knots_of(robot, move);
  if (knots.poses.size() == 1) {
    plan.motion = verify(robot, Trajectory::at_rest(move.q0, move.time.value_or(0.0)));
    plan.times.assign(move.poses.size(), 0.0);
    plan.missed = plan.times;
    return plan;
  }
  const CurveSpline spline = spline_through(knots, move.kind);
  plan.length = chord_length(spline, kLengthIntervals);
  PoseCurve curve;
  curve.add(spline);
  LineSamples samples(robot, move.q0, std::move(curve), move.task, CurveLaw::kGiven);
  if (!samples.follow()) {
    blame(plan, knots, samples.fault());
    return plan;
  }
  const LineMove run{.q0 = move.q0, .time = move.time, .speed = move.speed};
  plan.motion = run_unit_motion(robot, run, samples.motion(), plan.length, Jerk::kFree);
  if (!plan.ok()) return plan;
  plan.times.assign(move.poses.size(), 0.0);
  plan.missed = plan.times;
  for (std::size_t k = 1; k < knots.times.size(); ++k) {
    const double t = knots.times[k] * plan.motion.trajectory->duration();
    std::fill(plan.times.begin() + knots.indices[k], plan.times.end(), t);
  }
  return plan;
}

}  // namespace armlet
