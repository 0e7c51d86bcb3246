#include "armlet/cell/motion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/cell/clock.hpp"
#include "armlet/trajectory/profile.hpp"

using namespace armlet;

namespace {

constexpr std::int64_t kStart = 250'000'000;

// Two joints on a straight line in joint space: 0 to (1, -2) in 2 s.
Trajectory line() {
  return {{{{quintic_segment({}, {.q = 1.0}, 2.0)}, 1.0},
           {{quintic_segment({}, {.q = -2.0}, 2.0)}, -2.0}},
          2.0};
}

struct State {
  Eigen::VectorXd q{Eigen::VectorXd::Zero(2)};
  Eigen::VectorXd qd{Eigen::VectorXd::Zero(2)};
  Eigen::VectorXd qdd{Eigen::VectorXd::Zero(2)};
};

State state_at(const Motion& motion, std::int64_t t_ns) {
  State state;
  motion.sample(t_ns, state.q, state.qd, state.qdd);
  return state;
}

const Eigen::Vector2d kMaxAccel(6.0, 6.0);

}  // namespace

TEST_CASE("a motion ends exactly on its target, at rest") {
  const Motion motion(line(), kStart);
  CHECK(motion.end_ns() == kStart + 2'000'000'000);
  const State end = state_at(motion, motion.end_ns());
  CHECK(end.q == Eigen::Vector2d(1.0, -2.0));
  CHECK(end.qd.isZero(0.0));
  CHECK(end.qdd.isZero(0.0));
  CHECK(motion.reaches_end());
}

TEST_CASE("stopping stays on the path, is continuous, and respects the accelerations") {
  for (const double when : {0.05, 0.4, 1.0, 1.5}) {
    CAPTURE(when);
    Motion motion(line(), kStart);
    const std::int64_t stop_ns = kStart + to_ns(when);
    const State before = state_at(motion, stop_ns);
    motion.stop(stop_ns, kMaxAccel);
    REQUIRE_FALSE(motion.reaches_end());
    CHECK(state_at(motion, stop_ns).q == before.q);
    CHECK(motion.end_ns() < kStart + 2'000'000'000);
    State last = before;
    const std::int64_t step = 100'000;
    for (std::int64_t t = stop_ns + step; t <= motion.end_ns(); t += step) {
      const State now = state_at(motion, t);
      CHECK(std::abs(now.q[1] + 2.0 * now.q[0]) < 1e-12);
      CHECK(now.qdd.cwiseAbs().maxCoeff() <= 6.0 * (1.0 + 1e-3));
      CHECK((now.qd - last.qd).cwiseAbs().maxCoeff() <= 6.1e-4);
      CHECK(now.q[0] >= last.q[0]);
      last = now;
    }
    CHECK(last.qd.cwiseAbs().maxCoeff() < 1e-3);
    CHECK(state_at(motion, motion.end_ns()).qd.isZero(0.0));
  }
}

TEST_CASE("speed is the slope of position while slowing down") {
  Motion motion(line(), 0);
  motion.stop(700'000'000, kMaxAccel);
  for (std::int64_t t = 710'000'000; t < motion.end_ns() - 2'000'000; t += 7'000'000) {
    const State a = state_at(motion, t - 10'000);
    const State b = state_at(motion, t + 10'000);
    const State now = state_at(motion, t);
    CHECK((b.q[1] - a.q[1]) / 2e-5 == doctest::Approx(now.qd[1]).epsilon(1e-6));
    CHECK((b.qd[1] - a.qd[1]) / 2e-5 == doctest::Approx(now.qdd[1]).epsilon(1e-5));
  }
}

TEST_CASE("just before its end a motion arrives rather than stops") {
  Motion motion(line(), 0);
  motion.stop(1'999'900'000, kMaxAccel);
  CHECK(motion.reaches_end());
  CHECK(motion.end_ns() == 2'000'000'000);
}

TEST_CASE("a second stop changes nothing") {
  Motion motion(line(), 0);
  motion.stop(500'000'000, kMaxAccel);
  const std::int64_t end_ns = motion.end_ns();
  motion.stop(510'000'000, kMaxAccel);
  CHECK(motion.end_ns() == end_ns);
}
