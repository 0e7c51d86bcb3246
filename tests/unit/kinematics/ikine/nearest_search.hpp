// The nearest joint values that reach a goal, by a dense search over a joint that it leaves free.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "random_arm.hpp"

namespace armlet::nearest {

using Eigen::Isometry3d;
using Eigen::VectorXd;

// A joint at its copy inside the limits that is nearest to the seed; how far
// that is.
inline double nearest_copy(const Robot& robot, int i, double value, double seed) {
  double best = INFINITY;
  const int turns = robot.is_revolute(i) ? 3 : 0;
  for (int k = -turns; k <= turns; ++k) {
    const double copy = value + 2.0 * kPi * k;
    if (copy >= robot.lower()[i] - 1e-12 && copy <= robot.upper()[i] + 1e-12)
      best = std::min(best, std::abs(copy - seed));
  }
  return best;
}

inline double change_of(const Robot& robot, const VectorXd& q, const VectorXd& seed) {
  double change = 0.0;
  for (int i = 0; i < robot.n(); ++i)
    change = std::max(change, nearest_copy(robot, i, q[i], seed[i]));
  return change;
}

// The least value of a function of one variable: on a grid, then around its
// best point.
template <class Function>
inline double least_of(double from, double to, int steps, const Function& f) {
  const double h = (to - from) / steps;
  double best = INFINITY, at = from;
  for (int k = 0; k <= steps; ++k) {
    const double value = f(from + k * h);
    if (value < best) {
      best = value;
      at = from + k * h;
    }
  }
  double low = std::max(from, at - h), high = std::min(to, at + h);
  for (int k = 0; k < 60; ++k) {
    const double a = low + 0.382 * (high - low), b = high - 0.382 * (high - low);
    const double fa = f(a), fb = f(b);
    best = std::min({best, fa, fb});
    (fa <= fb ? high : low) = fa <= fb ? b : a;
  }
  return best;
}

// Joints a and b rotate about one line at q, in one direction (sign 1) or against
// each other.
struct Pair {
  int a, b;
  double sign;
};

inline double least_of_pair(const Robot& robot, const Pair& pair, const VectorXd& q,
                            const VectorXd& seed) {
  double others = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    if (i != pair.a && i != pair.b)
      others = std::max(others, nearest_copy(robot, i, q[i], seed[i]));
  }
  return least_of(robot.lower()[pair.a], robot.upper()[pair.a], 400, [&](double t) {
    const double b = q[pair.b] + pair.sign * (q[pair.a] - t);
    return std::max(
        {others, std::abs(t - seed[pair.a]), nearest_copy(robot, pair.b, b, seed[pair.b])});
  });
}

// The other joints by Newton's method while one is turned on step by step from
// q.
class Followed {
 public:
  Followed(const Robot& robot, const VectorXd& q, int joint, const VectorXd& seed)
      : robot_(robot), goal_(forward(robot, q)), joint_(joint), seed_(seed), q_(q) {}

  double least() {
    constexpr int kSteps = 72;
    const double h = 2.0 * kPi / kSteps;
    double best = change_of(robot_, q_, seed_);
    VectorXd at = q_;
    for (const double way : {h, -h}) {
      VectorXd q = q_;
      for (int k = 0; k < kSteps / 2 && step(q, q[joint_] + way); ++k) {
        const double change = change_of(robot_, q, seed_);
        if (change >= best) continue;
        best = change;
        at = q;
      }
    }
    double width = h;
    for (int k = 0; k < 60; ++k) {  // downhill in ever smaller steps
      bool better = false;
      for (const double way : {width, -width}) {
        VectorXd q = at;
        if (!step(q, q[joint_] + way)) continue;
        const double change = change_of(robot_, q, seed_);
        if (change >= best) continue;
        best = change;
        at = q;
        better = true;
      }
      if (!better) width *= 0.6;
    }
    return best;
  }

 private:
  bool step(VectorXd& q, double value) const {
    q[joint_] = value;
    for (int k = 0; k < 8; ++k) {
      Jacobian J;
      const Isometry3d T = forward_and_jacobian(robot_, q, J);
      Vector6d e;
      e << goal_.translation() - T.translation(),
          rotation_log(goal_.linear() * T.linear().transpose());
      if (e.norm() < 1e-10) return true;
      J.col(joint_).setZero();
      Eigen::MatrixXd H = J.transpose() * J;
      H.diagonal().array() += 1e-13;
      H(joint_, joint_) = 1.0;
      const VectorXd more = H.ldlt().solve(J.transpose() * e);
      if (!(more.cwiseAbs().maxCoeff() < 0.5)) return false;
      q += more;
    }
    return false;
  }

  const Robot& robot_;
  Isometry3d goal_;
  int joint_;
  const VectorXd& seed_;
  VectorXd q_;
};

inline VectorXd perturbed(const Robot& robot, const VectorXd& q, Random& random) {
  VectorXd seed = q;
  switch (random.below(3)) {
    case 0:
      seed[static_cast<int>(random.below(static_cast<std::uint64_t>(robot.n())))] +=
          random.below(2) == 0 ? kPi / 18 : -kPi / 18;
      break;
    case 1:
      for (double& value : seed) value += random.uniform(-0.3, 0.3);
      break;
    default:
      seed = random_joints(robot, random);
  }
  return clamp_to_limits(robot, seed);
}

// Within the limits, every other time with a joint or two at theirs.
inline VectorXd on_limits(const Robot& robot, Random& random) {
  VectorXd q = random_joints(robot, random);
  for (int k = static_cast<int>(random.below(3)); k > 0; --k) {
    const int i = static_cast<int>(random.below(static_cast<std::uint64_t>(robot.n())));
    q[i] = random.below(2) == 0 ? robot.lower()[i] : robot.upper()[i];
  }
  return q;
}

struct Score {
  int farther = 0;
  int missed = 0;
  double worst = 0.0;
};

inline void judge(const Robot& robot, const VectorXd& q, const VectorXd& seed, double least,
                  IkMethod method, Score& score) {
  const Isometry3d goal = forward(robot, q);
  const IkResult ik = solve_ik(robot, goal, {.seed = seed, .method = method});
  const bool good = ik.ok() && within_limits(robot, ik.q, 0.0) &&
                    (forward(robot, ik.q).translation() - goal.translation()).norm() < 1.001e-6 &&
                    angle_between(forward(robot, ik.q), goal) < 1.001e-6;
  score.missed += good ? 0 : 1;
  if (!good) return;
  const double more = (ik.q - seed).cwiseAbs().maxCoeff() - least;
  score.farther += more > 1e-6 ? 1 : 0;
  score.worst = std::max(score.worst, more);
}

// The change of the nearest solution that the closed form finds, which knows of other curves and
// branches than the one through q; infinite if it makes use of the tolerance.
inline double closed_form_change(const Robot& robot, const VectorXd& q, const VectorXd& seed) {
  const Isometry3d goal = forward(robot, q);
  const IkResult ik = solve_ik(robot, goal, {.seed = seed});
  if (!ik.ok()) return INFINITY;
  const Isometry3d T = forward(robot, ik.q);
  const bool exact =
      (T.translation() - goal.translation()).norm() < 1e-9 && angle_between(T, goal) < 1e-8;
  return exact ? (ik.q - seed).cwiseAbs().maxCoeff() : INFINITY;
}

}  // namespace armlet::nearest
