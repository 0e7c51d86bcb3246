#include "armlet/cell/motion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/cell/clock.hpp"
#include "armlet/core/random.hpp"
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
const Eigen::Vector2d kMaxJerk(120.0, 120.0);

}  // namespace

TEST_CASE("a motion ends exactly on its target, at rest") {
  const Motion motion(line(), kStart);
  CHECK(motion.end_ns() == kStart + 2'000'000'000);
  const State end = state_at(motion, motion.end_ns());
  CHECK(end.q == Eigen::Vector2d(1.0, -2.0));
  CHECK(end.qd.isZero(0.0));
  CHECK(end.qdd.isZero(0.0));
  CHECK_FALSE(motion.is_stopped());
}

TEST_CASE("stopping stays on the path, and keeps to the accelerations and jerks") {
  for (const double when : {0.05, 0.4, 1.0, 1.5}) {
    CAPTURE(when);
    Motion motion(line(), kStart);
    const std::int64_t stop_ns = kStart + to_ns(when);
    const State before = state_at(motion, stop_ns);
    motion.stop(stop_ns, kMaxAccel, kMaxJerk);
    REQUIRE(motion.is_stopped());
    CHECK(state_at(motion, stop_ns).q == before.q);
    CHECK(motion.end_ns() < kStart + 2'000'000'000);
    State last = before;
    const std::int64_t step = 100'000;
    for (std::int64_t t = stop_ns + step; t <= motion.end_ns(); t += step) {
      const State now = state_at(motion, t);
      CHECK(std::abs(now.q[1] + 2.0 * now.q[0]) < 1e-12);
      CHECK(now.qdd.cwiseAbs().maxCoeff() <= 6.0 * (1.0 + 1e-9));
      CHECK((now.qdd - last.qdd).cwiseAbs().maxCoeff() <= 120.0 * 1e-4 * (1.0 + 1e-6));
      CHECK(now.q[0] >= last.q[0]);
      last = now;
    }
    CHECK(last.qd.cwiseAbs().maxCoeff() < 1e-3);
    CHECK(state_at(motion, motion.end_ns()).qd.isZero(0.0));
  }
}

TEST_CASE("speed is the slope of position while slowing down") {
  Motion motion(line(), 0);
  motion.stop(700'000'000, kMaxAccel, kMaxJerk);
  for (std::int64_t t = 700'500'000; t < motion.end_ns() - 1'000'000; t += 7'000'000) {
    const State a = state_at(motion, t - 10'000);
    const State b = state_at(motion, t + 10'000);
    const State now = state_at(motion, t);
    CHECK((b.q[1] - a.q[1]) / 2e-5 == doctest::Approx(now.qd[1]).epsilon(1e-6));
    CHECK((b.qd[1] - a.qd[1]) / 2e-5 == doctest::Approx(now.qdd[1]).epsilon(1e-5));
  }
}

TEST_CASE("just before its end a stop comes to rest where the motion would") {
  Motion motion(line(), 0);
  motion.stop(1'999'900'000, kMaxAccel, kMaxJerk);
  CHECK(motion.is_stopped());
  CHECK(motion.end_ns() <= 2'000'000'000);
  CHECK((state_at(motion, motion.end_ns()).q - Eigen::Vector2d(1.0, -2.0)).norm() < 1e-9);
}

TEST_CASE("a motion that is stopped before it has begun does not move at all") {
  Motion motion(line(), kStart);
  motion.stop(kStart, kMaxAccel, kMaxJerk);
  CHECK(motion.is_stopped());
  CHECK(motion.end_ns() == kStart);
  CHECK(state_at(motion, kStart).q.isZero(0.0));
  CHECK(state_at(motion, kStart + 1'000'000).q.isZero(0.0));
}

// Constant speed v, deceleration a that is built up and taken back with jerk j: it takes
// v / a + a / j, and half of that time times v is the distance.
TEST_CASE("from constant speed a stop takes v / a + a / j and covers half of that times v") {
  const Trapezoid shape = trapezoid_with_ramp(4.0, 4.0, 1.0);
  Motion motion({{{trapezoid_segments(0.0, 4.0, shape), 4.0}}, 4.0}, 0);
  motion.stop(2'000'000'000, Eigen::VectorXd::Constant(1, 5.0), Eigen::VectorXd::Constant(1, 50.0));
  Eigen::VectorXd q(1), qd(1), qdd(1);
  motion.sample(2'000'000'000, q, qd, qdd);
  const double from = q[0];
  const double speed = qd[0];
  CHECK(speed == doctest::Approx(shape.speed));
  const double time = speed / 5.0 + 5.0 / 50.0;
  motion.sample(motion.end_ns(), q, qd, qdd);
  // The brake aims a little below the limits.
  CHECK(to_seconds(motion.end_ns()) - 2.0 >= time);
  CHECK(to_seconds(motion.end_ns()) - 2.0 <= time * 1.005);
  CHECK(q[0] - from == doctest::Approx(0.5 * speed * time).epsilon(5e-3));
}

// One joint may slow down at its limit already while another has far to go.
TEST_CASE("one joint at its limit does not keep the others from stopping") {
  const Trapezoid quick = trapezoid_with_ramp(1.0, 1.0, 0.5);
  const Trapezoid slow = trapezoid_with_ramp(10.0, 10.0, 0.5);
  Motion motion(
      {{{trapezoid_segments(0.0, 1.0, quick), 1.0}, {trapezoid_segments(0.0, 10.0, slow), 10.0}},
       10.0},
      0);
  motion.stop(600'000'000, Eigen::Vector2d(4.0, 4.0), Eigen::Vector2d(40.0, 40.0));
  CHECK(motion.end_ns() < 1'600'000'000);
}

TEST_CASE("over random motions and instants no stop exceeds a limit or goes back") {
  Random random(7);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const double T = random.uniform(0.2, 3.0);
    std::vector<JointPath> joints;
    for (int i = 0; i < 3; ++i) {
      const double travel = random.uniform(-2.0, 2.0);
      const double own = T * random.uniform(0.3, 1.0);
      if (trial % 2 == 0) {
        joints.push_back({{quintic_segment({}, {.q = travel}, T)}, travel});
      } else {
        joints.push_back(
            {trapezoid_segments(0.0, travel, trapezoid_with_ramp(travel, own, own / 3)), travel});
      }
    }
    const Trajectory trajectory(std::move(joints), T);
    Eigen::VectorXd limits(3);
    for (int i = 0; i < 3; ++i)
      limits[i] = std::max(trajectory.peak(i, 2), 1e-3) * random.uniform(1.0, 2.0);
    Eigen::VectorXd jerks(3);
    for (int i = 0; i < 3; ++i)
      jerks[i] = std::max(trajectory.peak(i, 3), limits[i]) * random.uniform(1.0, 20.0);
    Motion motion(trajectory, 0);
    const std::int64_t stop_ns = to_ns(T * random.uniform(0.0, 1.0));
    motion.stop(stop_ns, limits, jerks);
    CHECK(motion.end_ns() <= to_ns(T));
    Eigen::VectorXd q(3), qd(3), qdd(3), last(3);
    motion.sample(stop_ns, last, qd, qdd);
    Eigen::VectorXd last_qdd = qdd;
    const Eigen::VectorXd heading = trajectory.end() - last;
    constexpr int kSamples = 4000;
    const double dt = to_seconds(motion.end_ns() - stop_ns) / kSamples;
    const bool smooth = trial % 2 == 0;  // the others jump in acceleration by themselves
    for (int k = 1; k < kSamples; ++k) {
      motion.sample(stop_ns + (motion.end_ns() - stop_ns) * k / kSamples, q, qd, qdd);
      for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(qdd[i]) <= limits[i] * (1.0 + 1e-9));
        // The instants are whole nanoseconds, at most one off.
        if (smooth) CHECK(std::abs(qdd[i] - last_qdd[i]) <= jerks[i] * (dt + 2e-9) * (1.0 + 1e-9));
        CHECK((q[i] - last[i]) * heading[i] >= -1e-15);  // rounding
      }
      last = q;
      last_qdd = qdd;
    }
  }
}

TEST_CASE("a second stop changes nothing") {
  Motion motion(line(), 0);
  motion.stop(500'000'000, kMaxAccel, kMaxJerk);
  const std::int64_t end_ns = motion.end_ns();
  motion.stop(510'000'000, kMaxAccel, kMaxJerk);
  CHECK(motion.end_ns() == end_ns);
}
