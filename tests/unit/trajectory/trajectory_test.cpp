#include "armlet/trajectory/trajectory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/trajectory/profile.hpp"

using namespace armlet;

namespace {

// Joint 1: quintic of 1 s then cubic of 0.5 s; joint 2: cubic of 1 s, then waits; joint 3: at rest.
Trajectory three_joints() {
  const Segment rise = quintic_segment({.q = 0.1}, {.q = 0.7, .v = 0.3}, 1.0);
  Segment tail = cubic_segment({.q = 0.7, .v = 0.3}, {.q = 0.9}, 0.5);
  tail.start = 1.0;
  const Segment second = cubic_segment({.q = -0.2}, {.q = 0.4}, 1.0);
  return {{{{rise, tail}, 0.9}, {{second}, 0.4}, {{}, 2.5}}, 1.5};
}

// A joint with pieces of any degree that begin at the given times; it may jump at each.
JointPath any_path(Random& random, const std::vector<double>& starts, double end) {
  JointPath path{.q_end = random.uniform(-1.0, 1.0)};
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const double next = k + 1 < starts.size() ? starts[k + 1] : end;
    const auto degree = static_cast<int>(random.below(Segment::kMaxDegree + 1));
    Segment piece{.start = starts[k], .duration = next - starts[k], .degree = degree};
    for (double& c : piece.c) c = random.uniform(-1.0, 1.0);  // those above the degree do not count
    path.segments.push_back(piece);
  }
  return path;
}

std::vector<double> any_starts(Random& random, std::size_t count, bool crowded) {
  std::vector<double> starts = {0.0};
  while (starts.size() < count) {
    const bool close = crowded && starts.size() % 16 != 0;
    starts.push_back(starts.back() + random.uniform(0.1, 1.0) * (close ? 1e-6 : 1.0));
  }
  return starts;
}

// What sample() gives is what the polynomials one by one give.
void check_samples(Random& random, const Trajectory& motion) {
  const int n = motion.n();
  Eigen::VectorXd q(n), qd(n), qdd(n);
  std::vector<double> times = motion.knots();
  for (int k = 0; k < 50; ++k) times.push_back(random.uniform(-0.1, 1.1 * motion.duration()));
  for (const double t : times) {
    motion.sample(t, q, qd, qdd);
    for (int i = 0; i < n; ++i) {
      CHECK(q[i] == motion.value(i, t));  // the same steps, so the same bits
      CHECK(qd[i] == doctest::Approx(motion.value(i, t, 1)).epsilon(1e-13).scale(1.0));
      CHECK(qdd[i] == doctest::Approx(motion.value(i, t, 2)).epsilon(1e-13).scale(1.0));
    }
  }
}

}  // namespace

TEST_CASE("all joints at once are the same as one by one, however the pieces lie") {
  Random random(11);
  for (const std::size_t pieces : {1, 2, 7, 16, 17, 40, 200}) {
    for (const int n : {1, 2, 3, 7}) {
      for (const bool crowded : {false, true}) {
        const std::vector<double> starts = any_starts(random, pieces, crowded);
        const double end = starts.back() + 0.5;
        std::vector<JointPath> together, apart;
        for (int i = 0; i < n; ++i) {
          together.push_back(any_path(random, starts, end));
          const std::vector<double> own = any_starts(random, 1 + random.below(pieces), crowded);
          apart.push_back(any_path(random, own, own.back() + 0.01));
        }
        check_samples(random, Trajectory(together, end + 0.1));
        together[random.below(together.size())] = {.q_end = -0.7};  // does not move at all
        check_samples(random, Trajectory(together, end + 0.1));
        double last = 0.0;
        for (const JointPath& path : apart) last = std::max(last, path.segments.back().end());
        apart.back() = {.q_end = 0.3};
        check_samples(random, Trajectory(apart, last));
      }
    }
  }
}

TEST_CASE("a state of another size is refused") {
  const Trajectory motion = three_joints();
  Eigen::VectorXd q(3), qd(3), qdd(2);
  CHECK_THROWS_AS(motion.sample(0.5, q, qd, qdd), ArgumentError);
}

TEST_CASE("time is clamped and the end is exactly the target") {
  const Trajectory motion = three_joints();
  Eigen::VectorXd q(3), qd(3), qdd(3);
  motion.sample(-1.0, q, qd, qdd);
  CHECK(q == Eigen::Vector3d(0.1, -0.2, 2.5));
  CHECK(qd.isZero(0.0));
  CHECK(qdd.isZero(0.0));
  motion.sample(1.5, q, qd, qdd);
  CHECK(q == Eigen::Vector3d(0.9, 0.4, 2.5));
  motion.sample(99.0, q, qd, qdd);
  CHECK(q == motion.end());
  CHECK(qd.isZero(0.0));
  CHECK(motion.start() == Eigen::Vector3d(0.1, -0.2, 2.5));
}

TEST_CASE("a joint that arrives early waits at its own target") {
  const Trajectory motion = three_joints();
  CHECK(motion.value(1, 1.2) == 0.4);
  CHECK(motion.value(1, 1.2, 1) == 0.0);
  CHECK(motion.value(2, 0.5, 2) == 0.0);
}

TEST_CASE("every derivative is the slope of the one below it") {
  const Trajectory motion = three_joints();
  const double h = 1e-5;
  for (int order = 0; order < 3; ++order) {
    for (double t = 0.05; t < 1.45; t += 0.1) {
      if (std::abs(t - 1.0) < 0.02) continue;
      const double slope =
          (motion.value(0, t + h, order) - motion.value(0, t - h, order)) / (2.0 * h);
      // Central differences err by h^2/6 times the third derivative, which is below 1e3 here.
      CHECK(slope == doctest::Approx(motion.value(0, t, order + 1)).epsilon(1e-6).scale(1.0));
    }
  }
}

TEST_CASE("knots list every piece of every joint once") {
  CHECK(three_joints().knots() == std::vector<double>{0.0, 1.0, 1.5});
  CHECK(Trajectory::at_rest(Eigen::Vector2d(1.0, 2.0), 0.0).knots() == std::vector<double>{0.0});
}

TEST_CASE("peaks and ranges are those of dense sampling, and never smaller") {
  // 3 t - 2 t^2 on [0, 1.2]: reverses at t = 0.75, where it is 1.125.
  const Segment hill{.start = 0.0, .duration = 1.2, .degree = 2, .c = {0.0, 3.0, -2.0}};
  const Trajectory parabola({{{hill}, hill.value(1.2)}}, 1.2);
  CHECK(parabola.range(0).upper == doctest::Approx(1.125).epsilon(1e-15));
  CHECK(parabola.range(0).lower == 0.0);
  CHECK(parabola.peak(0, 1) == doctest::Approx(3.0).epsilon(1e-15));
  CHECK(parabola.peak(0, 2) == doctest::Approx(4.0).epsilon(1e-15));

  const Trajectory motion = three_joints();
  for (int order = 1; order <= 2; ++order) {
    double sampled = 0.0;
    for (int k = 0; k <= 30000; ++k) {
      sampled = std::max(sampled, std::abs(motion.value(0, k * 1.5 / 30000.0, order)));
    }
    CHECK(motion.peak(0, order) >= sampled - 1e-12);
    CHECK(motion.peak(0, order) == doctest::Approx(sampled).epsilon(1e-6));
  }
}

TEST_CASE("stretching divides speed by the factor and acceleration by its square") {
  const Trajectory motion = three_joints();
  const Trajectory slow = motion.stretched(3.0);
  CHECK(slow.duration() == doctest::Approx(4.5).epsilon(1e-15));
  for (double t = 0.0; t < 1.5; t += 0.07) {
    CHECK(slow.value(0, 3.0 * t) == doctest::Approx(motion.value(0, t)).epsilon(1e-13));
    CHECK(slow.value(0, 3.0 * t, 1) ==
          doctest::Approx(motion.value(0, t, 1) / 3.0).epsilon(1e-12).scale(1.0));
    CHECK(slow.value(0, 3.0 * t, 2) ==
          doctest::Approx(motion.value(0, t, 2) / 9.0).epsilon(1e-12).scale(1.0));
  }
  CHECK_THROWS_AS((void)motion.stretched(0.0), ArgumentError);
}

TEST_CASE("a motion without joints lasts as long as it is declared") {
  const Trajectory nothing({}, 2.0);
  CHECK(nothing.n() == 0);
  CHECK(nothing.duration() == 2.0);
  CHECK(Trajectory().duration() == 0.0);
}

TEST_CASE("gaps, late starts, wrong durations and infinite coefficients are refused") {
  const Segment piece = cubic_segment({.q = 0.0}, {.q = 1.0}, 1.0);
  Segment late = piece;
  late.start = 0.5;
  Segment broken = piece;
  broken.c[2] = std::nan("");
  CHECK_THROWS_AS(Trajectory({{{late}, 1.0}}, 2.0), ArgumentError);
  CHECK_THROWS_AS(Trajectory({{{piece, piece}, 1.0}}, 2.0), ArgumentError);
  CHECK_THROWS_AS(Trajectory({{{broken}, 1.0}}, 2.0), ArgumentError);
  CHECK_THROWS_AS(Trajectory({{{piece}, 1.0}}, 0.5), ArgumentError);
  CHECK_THROWS_AS(Trajectory({{{piece}, std::nan("")}}, 1.0), ArgumentError);
  CHECK_THROWS_AS(Trajectory({}, -1.0), ArgumentError);
  CHECK_THROWS_AS(Trajectory({}, std::nan("")), ArgumentError);
}

TEST_CASE("motions join where one ends and the next starts, and nowhere else") {
  const Trajectory motion = three_joints();
  const Trajectory there_and_back = motion.then(motion.reversed());
  CHECK(there_and_back.duration() == 3.0);
  CHECK(there_and_back.start() == there_and_back.end());
  for (double t = 0.0; t <= 1.5; t += 0.05) {
    for (int i = 0; i < 3; ++i) {
      CHECK(there_and_back.value(i, t) == motion.value(i, t));
      CHECK(there_and_back.value(i, 3.0 - t) ==
            doctest::Approx(motion.value(i, t)).epsilon(1e-12).scale(1.0));
    }
  }
  CHECK_THROWS_AS((void)motion.then(motion), ArgumentError);
  CHECK_THROWS_AS((void)motion.then(Trajectory({}, 1.0)), ArgumentError);
}

TEST_CASE("continuity counts the derivatives that are the same on both sides of every knot") {
  const auto smooth = [](const Segment& piece) {
    return Trajectory({{{piece}, piece.value(piece.duration)}}, piece.duration).continuity(0);
  };
  CHECK(smooth({.duration = 1.0, .degree = 1, .c = {0.0, 1.0}}) == 0);
  CHECK(smooth(cubic_segment({}, {.q = 1.0}, 1.0)) == 1);
  CHECK(smooth(quintic_segment({}, {.q = 1.0}, 1.0)) == 2);
  // A stop from a speed: jumps there from rest, but takes over a motion without a jump.
  const Segment stop = quintic_segment({.v = 1.0, .a = 0.5}, {.q = 1.0}, 1.0);
  const Trajectory stopping({{{stop}, 1.0}}, 1.0);
  CHECK(stopping.continuity(0) == 0);
  CHECK(stopping.continuity(0, 1e-9, Trajectory::Start::kMoving) == 2);
  const Trajectory jump({{{{.duration = 1.0, .degree = 0, .c = {0.0}}}, 1.0}}, 1.0);
  CHECK(jump.continuity(0) == -1);
}
