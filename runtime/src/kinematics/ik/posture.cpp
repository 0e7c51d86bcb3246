#include "armlet/kinematics/posture.hpp"

#include "armlet/core/error.hpp"
#include "armlet/kinematics/manipulability.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

VectorXd wished(const Robot& robot, const PostureGoal& goal) {
  if (goal.posture == Posture::kMidRange) return 0.5 * (robot.upper() + robot.lower());
  check_size("q_given", goal.q_given.size(), robot.n());
  return goal.q_given;
}

// A joint with range 0 has weight 0.
VectorXd weights(const Robot& robot) {
  const VectorXd range = robot.upper() - robot.lower();
  return range.unaryExpr([](double r) { return r > 0.0 ? 1.0 / (r * r) : 0.0; });
}

}  // namespace

double posture_value(const Robot& robot, JointsIn q, const PostureGoal& goal) {
  check_size("q", q.size(), robot.n());
  if (goal.posture == Posture::kManipulability) return manipulability(robot, q);
  const VectorXd off = q - wished(robot, goal);
  return -0.5 * off.cwiseAbs2().dot(weights(robot)) / robot.n();
}

VectorXd posture_gradient(const Robot& robot, JointsIn q, const PostureGoal& goal) {
  check_size("q", q.size(), robot.n());
  if (goal.posture != Posture::kManipulability)
    return (wished(robot, goal) - q).cwiseProduct(weights(robot)) / robot.n();
  return manipulability_gradient(robot, q);
}

}  // namespace armlet
