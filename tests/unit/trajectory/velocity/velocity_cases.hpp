// What the tests of velocity commands have in common.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/velocity.hpp"

namespace armlet::velocity_cases {

struct State {
  Eigen::VectorXd q, qd, qdd;
};

inline State state_at(const Trajectory& motion, double t) {
  State state{Eigen::VectorXd(motion.n()), Eigen::VectorXd(motion.n()),
              Eigen::VectorXd(motion.n())};
  motion.sample(t, state.q, state.qd, state.qdd);
  return state;
}

// From where the motion is when its time of giving speeds ends.
inline void go_on(const Trajectory& motion, VelocityStart& start) {
  State next = state_at(motion, start.during);
  start.q = std::move(next.q);
  start.qd = std::move(next.qd);
  start.qdd = std::move(next.qdd);
}

// Whether it starts as given, ends at rest, and keeps to every limit in between, without a jump of
// an acceleration.
inline void check_motion(const Robot& robot, const VelocityStart& start, const Trajectory& motion) {
  CHECK((motion.start() - start.q).norm() == 0.0);
  CHECK((state_at(motion, 0.0).qd - start.qd).norm() < 1e-9);
  CHECK(state_at(motion, motion.duration()).qd.norm() < 1e-9);
  if (start.qdd.size() > 0) CHECK((state_at(motion, 0.0).qdd - start.qdd).norm() < 1e-9);
  for (int i = 0; i < robot.n(); ++i) {
    CHECK(motion.peak(i, 1) <= robot.max_speed()[i] * (1.0 + 1e-9));
    CHECK(motion.peak(i, 2) <= robot.max_accel()[i] * (1.0 + 1e-9));
    CHECK(motion.peak(i, 3) <= robot.max_jerk()[i] * (1.0 + 1e-9));
    const Trajectory::Start taken_over = Trajectory::Start::kMoving;
    CHECK(motion.continuity(i, 1e-7, taken_over) >= 2);
    CHECK(motion.range(i).upper <= robot.upper()[i] + 1e-9);
    CHECK(motion.range(i).lower >= robot.lower()[i] - 1e-9);
  }
}

// Random numbers for the laws.
struct Dice {
  std::mt19937_64 engine;
  double from(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine);
  }
  Eigen::VectorXd within(const Eigen::VectorXd& most) {
    Eigen::VectorXd x(most.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = from(-most[i], most[i]);
    return x;
  }
};

// Of random positions in the middle of the joint ranges the farthest from a singular one.
inline Eigen::VectorXd good_position(const Robot& robot, Dice& dice) {
  Eigen::VectorXd best = robot.home();
  double farthest = 0.0;
  for (int k = 0; k < 20; ++k) {
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) {
      const double lower = std::max(robot.lower()[i], -3.0);
      const double upper = std::min(robot.upper()[i], 3.0);
      q[i] = dice.from(0.7 * lower + 0.3 * upper, 0.3 * lower + 0.7 * upper);
    }
    const Eigen::MatrixXd J = jacobian(robot, q);
    const Eigen::VectorXd s = singular_values(J).s;
    const double least = s[std::min<Eigen::Index>(robot.n(), 6) - 1];
    if (least <= farthest) continue;
    farthest = least;
    best = q;
  }
  return best;
}

// A velocity that the tool of this arm can hold, of at most `most` m/s and rad/s; zero if it cannot
// hold any: two joints of a plane, or three of a shoulder, move the tool on circles only.
inline Vector6d holdable(const Robot& robot, double most, Dice& dice) {
  Vector6d twist = Vector6d::Zero();
  const auto any = [&](int k) { twist[k] = dice.from(-most, most); };
  if (robot.n() >= 6) {
    for (int k = 0; k < 6; ++k) any(k);
  } else if (robot.name() == "planar3") {
    for (const int k : {0, 1, 5}) any(k);
  } else if (robot.n() == 4) {
    for (const int k : {0, 1, 2, 5}) any(k);
  } else if (robot.n() == 5) {
    any(2);
  }
  return twist;
}

inline VelocityStart standing(const Eigen::VectorXd& q, double during) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(q.size());
  return {.q = q, .qd = none, .qdd = none, .during = during};
}

// Periods of 1 ms to 200 ms, the short ones as often as the long ones.
inline double some_period(Dice& dice) {
  return 1e-3 * std::round(std::exp(dice.from(0.0, std::log(200.0))));
}

struct Resent {
  double apart = 0.0;  // of positions, rad or m, and speeds
  int compared = 0;
};

// Sends random commands, each of them once for the whole time and again and again.
template <class Plan>
Resent resend(Dice& dice, VelocityStart start, int commands, const Plan& plan) {
  Resent result;
  for (int c = 0; c < commands; ++c) {
    const double period = some_period(dice);
    const int times = period < 0.01 ? 12 : 3;
    const auto command = plan(start);
    VelocityStart once = start, often = start;
    once.during = period * times;
    often.during = period;
    once.same.reset();
    often.same.reset();
    const VelocityPlan whole = command(once);
    bool done = whole.motion.has_value();
    for (int k = 0; done && k < times; ++k) {
      const VelocityPlan part = command(often);
      done = part.motion.has_value();
      if (!done) break;
      go_on(*part.motion, often);
      often.same = part.take_up;
    }
    if (!done) continue;
    go_on(*whole.motion, once);
    ++result.compared;
    result.apart = std::max({result.apart, (once.q - often.q).cwiseAbs().maxCoeff(),
                             (once.qd - often.qd).cwiseAbs().maxCoeff()});
    start = once;
    start.fastest = whole.take_up.fastest;
  }
  return result;
}

}  // namespace armlet::velocity_cases
