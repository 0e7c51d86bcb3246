#include "armlet/kinematics/limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"
#include "kinematics/forward/periodic.hpp"

namespace armlet {

std::vector<LimitViolation> limit_violations(const Robot& robot, JointsIn q, double tolerance) {
  check_size("q", q.size(), robot.n());
  std::vector<LimitViolation> violations;
  for (int i = 0; i < robot.n(); ++i) {
    const Joint& joint = robot.joint(i);
    // Written so that NaN counts as outside.
    if (!(q[i] <= joint.upper + tolerance)) {
      violations.push_back({i, q[i], joint.upper});
    } else if (q[i] < joint.lower - tolerance) {
      violations.push_back({i, q[i], joint.lower});
    }
  }
  return violations;
}

bool within_limits(const Robot& robot, JointsIn q, double tolerance) {
  check_size("q", q.size(), robot.n());
  return ((q.array() <= robot.upper().array() + tolerance) &&
          (q.array() >= robot.lower().array() - tolerance))
      .all();
}

Eigen::VectorXd clamp_to_limits(const Robot& robot, JointsIn q) {
  check_size("q", q.size(), robot.n());
  return q.cwiseMax(robot.lower()).cwiseMin(robot.upper());
}

double wrapped_within(double angle, double near, double lower, double upper) {
  constexpr double kRevolution = 2.0 * kPi;
  if (!(std::abs(angle - near) <= kPi)) angle = nearest_copy_of_angle(angle, near);
  // Moves the angle by whole revolutions into the range, from either side.
  if (angle > upper) angle -= kRevolution * std::ceil((angle - upper) / kRevolution);
  if (angle < lower) angle += kRevolution * std::ceil((lower - angle) / kRevolution);
  if (angle > upper) {  // no copy is inside: choose the one just above or the one just below
    const double below = angle - kRevolution;
    if (lower - below < angle - upper) angle = below;
  }
  return angle;
}

Eigen::VectorXd wrap_near(const Robot& robot, JointsIn q, JointsIn q_near) {
  check_size("q", q.size(), robot.n());
  check_size("q_near", q_near.size(), robot.n());
  Eigen::VectorXd wrapped = q;
  for (int i = 0; i < robot.n(); ++i) {
    if (!is_periodic(robot, i)) continue;
    wrapped[i] = wrapped_within(q[i], q_near[i], robot.lower()[i] - 1e-9, robot.upper()[i] + 1e-9);
  }
  return wrapped;
}

Eigen::VectorXd limit_margins(const Robot& robot, JointsIn q) {
  check_size("q", q.size(), robot.n());
  return (q - robot.lower()).cwiseMin(robot.upper() - q);
}

std::string describe(const Robot& robot, const LimitViolation& violation) {
  const Joint& joint = robot.joint(violation.joint);
  return fmt::format(
      "joint {} would {} to {}; its range is {} to {}", violation.joint + 1, joint_word(joint.kind),
      format_joint_value(joint.kind, violation.value, violation.limit),
      format_joint_value(joint.kind, joint.lower), format_joint_value(joint.kind, joint.upper));
}

}  // namespace armlet
