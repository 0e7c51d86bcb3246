#include "armlet/trajectory/drawing_times.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace armlet;

namespace {

// One joint that takes steps of 1 s with a speed that jumps from piece to piece.
Trajectory steps(int pieces) {
  JointPath path;
  double q = 0.0;
  for (int k = 0; k < pieces; ++k) {
    Segment piece{.start = 1.0 * k, .duration = 1.0, .degree = 1};
    piece.c[0] = q;
    piece.c[1] = k % 2 == 0 ? 1.0 : 2.0;
    q += piece.c[1];
    path.segments.push_back(piece);
  }
  path.q_end = q;
  return {{path}, 1.0 * pieces};
}

}  // namespace

TEST_CASE("a motion is looked at evenly, and on both sides of each knot") {
  const Trajectory motion = steps(3);
  const std::vector<double> times = drawing_times(motion, 11);
  CHECK(std::ranges::is_sorted(times));
  CHECK(times.front() == 0.0);
  CHECK(times.back() == 3.0);
  CHECK(times.size() == 15);
  for (const double knot : {1.0, 2.0}) {
    const auto at = std::ranges::find(times, knot);
    REQUIRE(at != times.end());
    CHECK(motion.value(0, *(at - 1), 1) != motion.value(0, *at, 1));  // the jump is upright
  }
}

TEST_CASE("a motion without duration is one time, and one of many pieces not too many") {
  CHECK(drawing_times(Trajectory::at_rest(Eigen::VectorXd::Zero(2), 0.0)) ==
        std::vector<double>{0.0});
  CHECK(drawing_times(steps(5000)).size() == 4000);
}
