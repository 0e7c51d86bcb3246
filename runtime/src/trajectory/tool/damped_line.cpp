#include "armlet/trajectory/damped_line.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/spline.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "math/solvers.hpp"
#include "trajectory/timing/smooth_run.hpp"
#include "trajectory/tool/curve_plan.hpp"

namespace armlet {
namespace {

constexpr int kSteps = 512;
constexpr int kCells = 96;  // number of pieces of a jerk-limited speed
// m, equivalent length of a rotation by one radian
constexpr double kRotationLengthOfDamping = 0.2;
constexpr double kCatchUp = 2.0;    // largest step, as a multiple of the usual one
constexpr double kShortest = 1e-9;  // s, resolution of the clock
constexpr double kGain = 0.05;      // of the remaining error, per step
constexpr double kSettled = 0.01;   // of a usual step: larger errors are corrected
// rad or m, per step: the error no longer decreases
constexpr double kStill = 1e-7;
constexpr int kPerInterval = 4;  // samples between two steps for the deviation

// The error of the tool, and the rows of the Jacobian that the task uses: all, or the position.
struct Offset {
  Eigen::VectorXd error;
  Eigen::MatrixXd J;
};

Offset offset_from(const Robot& robot, const Eigen::Isometry3d& T_world_tool, IkTask task,
                   const Eigen::VectorXd& q) {
  Jacobian J;
  const Vector6d error = pose_error(forward_and_jacobian(robot, q, J), T_world_tool);
  if (task == IkTask::kPositionFirst) return {error.head<3>(), J.topRows<3>()};
  return {error, J};
}

// An error as an equivalent length, m.
double size_of(const Eigen::VectorXd& error) {
  return error.head<3>().norm() +
         (error.size() > 3 ? kRotationLengthOfDamping * error.tail<3>().norm() : 0.0);
}

// One damped step of the joints towards a pose. The damping grows from 0 as the smallest singular
// value falls below its threshold, so the step is exact if the arm is not near a singularity. An
// error left from there, larger than a usual step, is reduced gradually.
void step_towards(const Robot& robot, const Eigen::Isometry3d& T_world_tool, IkTask task,
                  double damping, double usual, Eigen::VectorXd& q) {
  auto [error, J] = offset_from(robot, T_world_tool, task, q);
  const double size = size_of(error);
  if (size > usual) error *= std::min(kCatchUp * usual, usual + kGain * (size - usual)) / size;
  const bool is_wide = J.cols() >= J.rows();
  Eigen::MatrixXd square = J.transpose() * J;
  if (is_wide) square = J * J.transpose();
  const double smallest = std::max(smallest_eigenvalue(square), 0.0);
  const double limit = damping * damping;
  if (smallest < limit) square.diagonal().array() += limit - smallest;
  const SymmetricFactors<Eigen::Dynamic> factors(square);
  if (is_wide) {
    q += J.transpose() * factors.solve(error);
  } else {
    q += factors.solve(J.transpose() * error);
  }
}

// Measures the deviation. `path`: the joint path, its parameter in metres of the line and beyond.
void measure(const Robot& robot, const Trajectory& path, const CurvePiece& line, IkTask task,
             DampedLine& plan) {
  Eigen::VectorXd q(robot.n());
  const int samples =
      static_cast<int>(std::lround(path.duration() / line.length * kSteps)) * kPerInterval;
  for (int k = 0; k <= samples; ++k) {
    const double s = path.duration() * k / samples;
    const double x = std::min(s / line.length, 1.0);
    for (int i = 0; i < robot.n(); ++i) q[i] = path.value(i, s);
    const Vector6d error = pose_error(forward(robot, q), line.at(x));
    if (error.head<3>().norm() > plan.deviation) {
      plan.deviation = error.head<3>().norm();
      plan.at = x;
    }
    if (task == IkTask::kPose) plan.angle = std::max(plan.angle, error.tail<3>().norm());
  }
}

void check(const Robot& robot, const LineMove& move, double damping) {
  check_line_move(robot, move);
  check_positive("damping", damping);
  if (move.task != IkTask::kPose && move.task != IkTask::kPositionFirst)
    throw ArgumentError("A damped line needs a goal with a place, or a place and an orientation.");
}

// Speed limits of the tool along the path: where it catches up, it travels farther than the line.
std::vector<SpeedZone> zones_of(const Robot& robot, const LineMove& move,
                                const std::vector<Eigen::VectorXd>& joints,
                                const std::vector<double>& s) {
  std::vector<SpeedZone> zones(1, {.from = 0.0, .to = s.back()});
  if (move.tool_accel) zones[0].acceleration = *move.tool_accel;
  if (!move.tool_speed) return zones;
  zones[0].speed = *move.tool_speed;
  Eigen::Vector3d before = forward(robot, joints[0]).translation();
  for (std::size_t k = 1; k < joints.size(); ++k) {
    const Eigen::Vector3d position = forward(robot, joints[k]).translation();
    const double further = (position - before).norm() / (s[k] - s[k - 1]);
    before = position;
    if (further > 1.0)
      zones.push_back({.from = s[k - 1], .to = s[k], .speed = *move.tool_speed / further});
  }
  return zones;
}

// The shortest duration of the joint path, its parameter in metres. Where joints nearly jump,
// limited jerk would take many times as long; accelerations jump there instead.
struct LeastTime {
  Trajectory motion{};
  Jerk jerk = Jerk::kLimited;
};

LeastTime fastest_on(const Robot& robot, const LineMove& move, const Trajectory& path,
                     std::span<const SpeedZone> zones) {
  std::vector<AxisLimits> limits = axis_limits(robot);
  const double share = move.time || move.tool_speed ? 1.0 : move.speed;
  for (AxisLimits& l : limits) {
    l.speed *= share;
    l.acceleration *= share * share;
    l.jerk *= share * share * share;
  }
  const SpeedAlongPath speed = fastest_along(path, limits, kSteps, zones);
  TimedRun smooth = smooth_run(path, limits, speed, kCells, zones);
  if (!smooth.s.empty()) return {std::move(smooth.motion)};
  return {time_optimal(path, limits, kSteps, zones), Jerk::kFree};
}

// The motion along the joint path in the shortest or in the requested time.
MotionPlan run(const Robot& robot, const LineMove& move, const Trajectory& path,
               std::span<const SpeedZone> zones) {
  const auto [fastest, jerk] = fastest_on(robot, move, path, zones);
  const double least = fastest.duration();
  if (!move.time) return verify(robot, fastest, true, jerk);
  const bool too_fast = *move.time < least * (1.0 - 1e-9);
  if (too_fast && (move.enforce_limits || *move.time < kShortest)) {
    MotionPlan refused{.too_fast = least_time(robot, fastest, jerk)};
    refused.too_fast->given = *move.time;
    refused.too_fast->least_time = least;
    return refused;
  }
  return verify(robot, fastest.stretched(*move.time / least), move.enforce_limits, jerk);
}

// Steps of the joints along the line, and after its end until the tool has reached it or comes no
// closer. `s` is the length along the line, m, and after its end the length that was caught up.
struct Walk {
  std::vector<double> s{};
  std::vector<Eigen::VectorXd> joints{};
};

Walk walk(const Robot& robot, const LineMove& move, const CurvePiece& line, double damping) {
  const double usual = line.length / kSteps;
  const auto left = [&](const Eigen::VectorXd& q, double x) {
    return size_of(offset_from(robot, line.at(x), move.task, q).error);
  };
  Walk out{.s = {0.0}, .joints = {move.q0}};
  for (int k = 1; k <= 2 * kSteps; ++k) {
    Eigen::VectorXd q = out.joints.back();
    const double x = std::min(static_cast<double>(k) / kSteps, 1.0);
    const double behind = left(q, x);
    if (k > kSteps && behind < kSettled * usual) break;
    step_towards(robot, line.at(x), move.task, damping, usual, q);
    // If no error is left from a singularity, corrects what the linear step leaves.
    if (left(q, x) < kSettled * usual)
      step_towards(robot, line.at(x), move.task, damping, usual, q);
    if (k > kSteps && (q - out.joints.back()).cwiseAbs().maxCoeff() < kStill) break;
    out.s.push_back(k <= kSteps ? k * usual : out.s.back() + std::min(behind, usual));
    out.joints.push_back(std::move(q));
  }
  return out;
}

DampedLine follow(const Robot& robot, const LineMove& move, const CurvePiece& line,
                  double damping) {
  DampedLine plan;
  if (!(line.length > 0.0)) {
    plan.motion = verify(robot, Trajectory::at_rest(move.q0, move.time.value_or(0.0)));
    return plan;
  }
  plan.length = line.travel();
  const auto [x, joints] = walk(robot, move, line, damping);
  std::vector<JointPath> paths;
  std::vector<double> values(joints.size());
  for (int i = 0; i < robot.n(); ++i) {
    for (std::size_t k = 0; k < joints.size(); ++k) values[k] = joints[k][i];
    paths.push_back({.segments = natural_spline(x, values), .q_end = values.back()});
  }
  const Trajectory path(std::move(paths), x.back());
  measure(robot, path, line, move.task, plan);
  plan.motion = run(robot, move, path, zones_of(robot, move, joints, x));
  return plan;
}

}  // namespace

DampedLine plan_damped_line(const Robot& robot, const LineMove& move, double damping) {
  check(robot, move, damping);
  return follow(robot, move, straight_piece(forward(robot, move.q0), move.T_world_goal), damping);
}

std::optional<DampedLine> plan_damped_arc(const Robot& robot, const Eigen::Vector3d& p_world_via,
                                          const LineMove& move, double damping) {
  check(robot, move, damping);
  check_finite("p_world_via", p_world_via);
  const auto piece = piece_over(forward(robot, move.q0), p_world_via, move.T_world_goal);
  if (!piece) return std::nullopt;
  return follow(robot, move, *piece, damping);
}

}  // namespace armlet
