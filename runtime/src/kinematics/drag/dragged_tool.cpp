#include "armlet/kinematics/dragged_tool.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"
#include "kinematics/ik/ik_search.hpp"
#include "position_model.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::VectorXd;

constexpr double kLineStep = 0.05;  // of the arm's length, and rad
constexpr int kMostLineSteps = 40;
constexpr int kIterations = 12;
constexpr double kLargestChange = 0.5;  // rad or m, of a joint in one step of the line
constexpr int kPositionSteps = 60;
constexpr int kReturnSteps = 6;  // back to the position after a rotation
constexpr int kRotationSteps = 40;
constexpr int kHalvings = 12;
constexpr double kArrived = 1e-9;       // m or rad
constexpr double kNoApproach = 1e-8;    // m
constexpr double kAlmost = 1e-3;        // m, and tenths of a radian
constexpr double kSameDistance = 1e-7;  // m, that a rotation may cost
constexpr double kLargestGoal = 1e6;    // m

// Changes of a joint in one call that goes gradually, rad or m. A rotation of the tool that was
// lost comes back over many calls; a fold of the arm is larger only if the tool comes nearer by it.
constexpr double kMoveAlways = 0.25;   // while the tool comes nearer, and
constexpr double kMoveForGain = 10.0;  // per length of the arm by which it does
constexpr double kTurnAlways = 0.2;    // while the tool only rotates, and
constexpr double kTurnForMove = 1.5;   // per change of a joint before that
constexpr double kLineForWay = 8.0;    // on the line, per length of the arm to the goal

class Drag {
 public:
  Drag(const Robot& robot, const Isometry3d& T_goal, JointsIn q, const DragOptions& options)
      : robot_(robot),
        goal_(T_goal),
        unbounded_(options.gradually ? 0.0 : std::numeric_limits<double>::infinity()),
        model_(robot, T_goal),
        q_(clamp_to_limits(robot, q)) {}

  DraggedTool run() {
    const VectorXd q_start = q_;
    const double most = kTurnAlways + kLineForWay * way() / robot_.length() + unbounded_;
    const bool arrives = follow_line();
    const bool goes_far = largest_change(q_, q_start) > most;
    if (arrives && !goes_far) return result();
    if (goes_far) q_ = q_start;
    const VectorXd q_before = q_;
    approach(q_, kPositionSteps);
    rotate(kTurnAlways + kTurnForMove * largest_change(q_, q_before) + unbounded_);
    polish();
    return result();
  }

 private:
  double way() const { return (goal_.translation() - forward(robot_, q_).translation()).norm(); }

  // Solves for poses on the straight line to the goal, each from the solution before it. Returns
  // whether the goal is reached; otherwise q_ is the last solution.
  bool follow_line() {
    const Isometry3d T_start = forward(robot_, q_);
    const double angle = angle_between(T_start, goal_);
    const double steps = std::ceil((way() / robot_.length() + angle) / kLineStep);
    const int count = static_cast<int>(std::clamp(steps, 1.0, 1.0 * kMostLineSteps));
    for (int k = 1; k <= count; ++k) {
      const double share = static_cast<double>(k) / count;
      const Isometry3d T = k == count ? goal_ : interpolate(T_start, goal_, share);
      JointArray next = to_array(q_);
      IkSolver solver(robot_, {.p = T.translation(), .R = T.linear()});
      if (!solver.solve_in_box(next, kIterations)) return false;
      const VectorXd q_next = to_vector(next, robot_.n());
      if (largest_change(q_next, q_) > kLargestChange) return false;
      q_ = q_next;
    }
    return true;
  }

  // Newton steps towards the position, each halved until it comes nearer.
  void approach(VectorXd& q, int steps) const {
    const VectorXd q_start = q;
    PositionModel::At at = model_.at(q);
    const double start = at.distance();
    for (int k = 0; k < steps && at.distance() > kArrived; ++k) {
      const VectorXd step = model_.step(q, at);
      double share = 1.0;
      PositionModel::At next;
      VectorXd q_next;
      for (int halved = 0; halved < kHalvings; ++halved, share *= 0.5) {
        q_next = clamp_to_limits(robot_, q + share * step);
        next = model_.at(q_next);
        if (next.distance() < at.distance()) break;
      }
      const double gain = at.distance() - next.distance();
      const double nearer = (start - next.distance()) / robot_.length();
      const double most = kMoveAlways + kMoveForGain * nearer + unbounded_;
      if (!(gain > 0.0) || largest_change(q_next, q_start) > most) return;
      q = q_next;
      at = next;
      if (gain < kNoApproach && at.distance() > kAlmost) return;
    }
  }

  // Rotates the tool while its point stays where it is: damped steps in the directions that do not
  // move it, each followed by a return to the position.
  //
  // most  change of a joint in all, rad or m.
  void rotate(double most) {
    const VectorXd q_start = q_;
    double damping = 1e-3;
    PositionModel::At at = model_.at(q_);
    for (int k = 0; k < kRotationSteps && at.angle() > kArrived; ++k) {
      const VectorXd step = model_.rotation_step(q_, at, damping);
      if (!(step.cwiseAbs().maxCoeff() > kArrived)) return;
      VectorXd next = clamp_to_limits(robot_, q_ + step);
      approach(next, kReturnSteps);
      if (largest_change(next, q_start) > most) return;
      const PositionModel::At there = model_.at(next);
      const double gain = at.angle() - there.angle();
      if (there.distance() > at.distance() + kSameDistance || !(gain > 0.0)) {
        damping *= 8.0;
        if (damping > 1e4) return;
        continue;
      }
      damping = std::max(damping / 8.0, 1e-9);
      q_ = next;
      at = there;
      if (gain < kArrived) return;
    }
  }

  // A pose that is almost reached is reached to the tolerance of solve_ik.
  void polish() {
    const PositionModel::At at = model_.at(q_);
    if (at.distance() > kAlmost || at.angle() > 10.0 * kAlmost) return;
    JointArray q = to_array(q_);
    IkSolver solver(robot_, {.p = goal_.translation(), .R = goal_.linear()});
    if (!solver.solve_in_box(q, kIterations)) return;
    const VectorXd q_new = to_vector(q, robot_.n());
    if (largest_change(q_new, q_) <= kTurnAlways) q_ = q_new;
  }

  DraggedTool result() const {
    const PositionModel::At at = model_.at(q_);
    DraggedTool out;
    out.q = q_;
    out.T_world_tool = forward(robot_, q_);
    out.distance = at.distance();
    out.angle = at.angle();
    if (!out.has_pose()) out.at_limit = model_.stopping(q_, at, out.has_position());
    return out;
  }

  const Robot& robot_;
  const Isometry3d& goal_;
  double unbounded_;  // 0, or infinity if changes have no bound
  PositionModel model_;
  VectorXd q_;
};

}  // namespace

DraggedTool drag_tool(const Robot& robot, const Isometry3d& T_world_goal, JointsIn q_now,
                      const DragOptions& options) {
  check_pose("goal", T_world_goal);
  check_size("q_now", q_now.size(), robot.n());
  check_finite("q_now", q_now);
  if (!(T_world_goal.translation().cwiseAbs().maxCoeff() <= kLargestGoal))
    throw ArgumentError("The goal of a dragged tool is at most 1e6 m away.");
  return Drag(robot, T_world_goal, q_now, options).run();
}

Isometry3d pose_to_keep(const Robot& robot, const Isometry3d& T_world_goal, JointsIn q_now) {
  if (fixed_tilt(robot)) return with_heading_of(robot, T_world_goal, q_now);
  if (robot.n() >= 6) return T_world_goal;
  return make_pose(forward(robot, q_now).linear(), T_world_goal.translation());
}

}  // namespace armlet
