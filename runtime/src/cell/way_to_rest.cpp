#include "cell/way_to_rest.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/trajectory/velocity.hpp"

namespace armlet {
namespace {

// Constant deceleration to rest, in time T at the value q + v T / 2.
JointPath slowing(double q, double v, double most, double lower, double upper) {
  if (v == 0.0) return {.q_end = q};
  const double room = v > 0.0 ? upper - q : q - lower;
  const double seconds = std::min(std::abs(v) / most, 2.0 * std::max(room, 0.0) / std::abs(v));
  if (!(seconds > 0.0)) return {.q_end = q};
  Segment segment{.start = 0.0, .duration = seconds, .degree = 2};
  segment.c[0] = q;
  segment.c[1] = v;
  segment.c[2] = -0.5 * v / seconds;
  return {.segments = {segment}, .q_end = std::clamp(q + 0.5 * v * seconds, lower, upper)};
}

}  // namespace

Trajectory way_to_rest(const Robot& robot, const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                       const Eigen::VectorXd& qdd) {
  if (qd.isZero(0.0)) return Trajectory::at_rest(q, 0.0);
  constexpr double kAtOnce = 1e-9;  // s
  VelocityPlan plan = plan_joint_velocity(robot, {.q = q, .qd = qd, .qdd = qdd, .during = kAtOnce},
                                          Eigen::VectorXd::Zero(robot.n()));
  if (plan.motion) return *std::move(plan.motion);
  std::vector<JointPath> joints;
  double duration = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    joints.push_back(
        slowing(q[i], qd[i], robot.max_accel()[i], robot.lower()[i], robot.upper()[i]));
    if (!joints.back().segments.empty())
      duration = std::max(duration, joints.back().segments[0].duration);
  }
  return Trajectory(std::move(joints), duration);
}

}  // namespace armlet
