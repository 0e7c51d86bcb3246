#include "armlet/kinematics/reach.hpp"

#include <algorithm>
#include <array>

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"

namespace armlet {
namespace {

constexpr int kSamples = 24;     // of one joint's range
constexpr int kNarrowings = 40;  // of the interval around the best sample; each leaves 0.62 of it
constexpr int kSweeps = 30;

// Element k of the van der Corput sequence to a base.
double spread(int k, int base) {
  double result = 0.0, weight = 1.0;
  for (; k > 0; k /= base) {
    weight /= base;
    result += weight * (k % base);
  }
  return result;
}

Eigen::VectorXd start(const Robot& robot, int k) {
  constexpr std::array<int, kMaxJoints> kBases = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  if (k == 0) return robot.home();
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const double share = spread(k, kBases[static_cast<std::size_t>(i)]);
    q[i] = robot.joint(i).is_continuous()
               ? kPi * (2.0 * share - 1.0)
               : robot.lower()[i] + (robot.upper()[i] - robot.lower()[i]) * share;
  }
  return q;
}

// Sets q[i] to the value that maximises the function while the other joints do not move.
double maximise_one(const Robot& robot, const std::function<double(JointsIn)>& function, int i,
                    Eigen::VectorXd& q) {
  // For a joint without limits one revolution is enough.
  const bool is_free = robot.joint(i).is_continuous();
  const double lower = is_free ? -kPi : robot.lower()[i], upper = is_free ? kPi : robot.upper()[i];
  const auto at = [&](double value) {
    q[i] = std::clamp(value, lower, upper);  // a sum may round beyond the limit
    return function(q);
  };
  double best_q = q[i], best = function(q);
  const auto consider = [&](double value) {
    const double found = at(value);
    if (found > best) {
      best = found;
      best_q = q[i];
    }
  };
  for (int k = 0; k <= kSamples; ++k) consider(lower + (upper - lower) * k / kSamples);
  const double width = (upper - lower) / kSamples;
  double left = std::max(lower, best_q - width), right = std::min(upper, best_q + width);
  constexpr double kGolden = 0.6180339887498949;
  for (int k = 0; k < kNarrowings; ++k) {
    const double a = right - kGolden * (right - left), b = left + kGolden * (right - left);
    if (at(a) >= at(b)) {
      right = b;
    } else {
      left = a;
    }
  }
  consider(0.5 * (left + right));
  q[i] = best_q;
  return best;
}

}  // namespace

Eigen::VectorXd maximise_over_joints(const Robot& robot,
                                     const std::function<double(JointsIn)>& function, int starts) {
  check_positive("starts", starts);
  Eigen::VectorXd best_q = robot.home();
  double best = function(best_q);
  for (int k = 0; k < starts; ++k) {
    Eigen::VectorXd q = start(robot, k);
    double value = function(q);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const double before = value;
      for (int i = 0; i < robot.n(); ++i) value = maximise_one(robot, function, i, q);
      if (value - before < 1e-12) break;
    }
    if (value > best) {
      best = value;
      best_q = q;
    }
  }
  return best_q;
}

Reach find_reach(const Robot& robot) {
  const Eigen::Isometry3d T_base_world = robot.T_world_base().inverse();
  const auto from_base = [&](JointsIn q) {
    return (T_base_world * forward(robot, q).translation()).norm();
  };
  Reach reach;
  reach.q_base = maximise_over_joints(robot, from_base);
  reach.from_base = from_base(reach.q_base);
  reach.q_axis = reach.q_base;
  reach.from_axis = reach.from_base;
  if (!robot.row(0).is_revolute()) return reach;
  // Frame 0 of the standard convention and frame 1 of the modified one have the first axis as z.
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  const Eigen::Isometry3d T_axis_world =
      link_frame(robot, robot.home(), standard ? 0 : 1).inverse();
  const auto from_axis = [&](JointsIn q) {
    return (T_axis_world * forward(robot, q).translation()).head<2>().norm();
  };
  reach.q_axis = maximise_over_joints(robot, from_axis);
  reach.from_axis = from_axis(reach.q_axis);
  return reach;
}

}  // namespace armlet
