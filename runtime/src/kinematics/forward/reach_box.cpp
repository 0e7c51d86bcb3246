#include <algorithm>
#include <cmath>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/kinematics/reach.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kBoxStarts = 12;
constexpr int kBoxSweeps = 60;
constexpr double kNoFarther = 1e-12;  // m

// The start of a search: the home position, then joint values spread over the ranges.
VectorXd box_start(const Robot& robot, int k) {
  VectorXd q = robot.home();
  if (k == 0) return q;
  for (int i = 0; i < robot.n(); ++i) {
    const double share = 0.6180339887498949 * k * (i + 1);
    const double low = std::max(robot.lower()[i], -kPi), high = std::min(robot.upper()[i], kPi);
    q[i] = std::clamp(low + (high - low) * (share - std::floor(share)), robot.lower()[i],
                      robot.upper()[i]);
  }
  return q;
}

// The value of joint i, within its limits, at which the point is farthest along a direction.
//
// v, w  the columns of the Jacobian: the point moves with v while the joint moves at 1.
double best_value(const Robot& robot, int i, double q, const Vector3d& along, const Vector3d& v,
                  const Vector3d& w) {
  const double lower = robot.lower()[i], upper = robot.upper()[i];
  if (!robot.is_revolute(i)) return along.dot(v) > 0.0 ? upper : along.dot(v) < 0.0 ? lower : q;
  // Rotated by x, the point is at a cos x + b sin x along the direction, up to a constant.
  const double a = -along.dot(w.cross(v)), b = along.dot(v);
  if (det::hypot(a, b) < kNoFarther) return q;
  const double best = wrapped_within(q + det::atan2(b, a), q, lower, upper);
  if (best >= lower && best <= upper) return best;
  const auto height = [&](double value) {
    return a * det::cos(value - q) + b * det::sin(value - q);
  };
  return height(lower) > height(upper) ? lower : upper;
}

// The largest coordinate of the tool point along a direction.
double farthest_along(const Robot& robot, const Vector3d& along) {
  if (robot.coupling() != nullptr) {
    const auto height = [&](JointsIn q) { return along.dot(forward(robot, q).translation()); };
    return height(maximise_over_joints(robot, height, 4));
  }
  double best = -INFINITY;
  for (int k = 0; k < kBoxStarts; ++k) {
    VectorXd q = box_start(robot, k);
    double reached = -INFINITY;
    for (int sweep = 0; sweep < kBoxSweeps; ++sweep) {
      for (int i = 0; i < robot.n(); ++i) {
        const Jacobian J = jacobian(robot, q);
        q[i] = best_value(robot, i, q[i], along, J.col(i).head<3>(), J.col(i).tail<3>());
      }
      const double now = along.dot(forward(robot, q).translation());
      if (now - reached < kNoFarther) break;
      reached = now;
    }
    best = std::max(best, along.dot(forward(robot, q).translation()));
  }
  return best;
}

struct KnownReachBox {
  using FromShape = void;
  explicit KnownReachBox(const Robot& robot) {
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = -farthest_along(robot, -Vector3d::Unit(axis));
      box.upper[axis] = farthest_along(robot, Vector3d::Unit(axis));
    }
  }
  ReachBox box;
};

}  // namespace

const ReachBox& reach_box(const Robot& robot) { return robot.derived<KnownReachBox>().box; }

}  // namespace armlet
