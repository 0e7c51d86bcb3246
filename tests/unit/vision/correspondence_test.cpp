#include "armlet/vision/correspondence.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "armlet/core/random.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::Index;

namespace {

PlanePoints random_points(Random& random, Index n, double side) {
  return PlanePoints::NullaryExpr(n, 2, [&] { return random.uniform(0.0, side); });
}

// Most pairs, then the smallest sum, by trying all orders of the points.
std::pair<int, double> best_by_trying(const PlanePoints& points, const PlanePoints& wanted,
                                      double within) {
  // A point more for each wanted one, which means none.
  std::vector<int> order(static_cast<std::size_t>(points.rows() + wanted.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::pair<int, double> best{-1, 0.0};
  do {
    int pairs = 0;
    double sum = 0.0;
    bool fits = true;
    for (Index i = 0; i < wanted.rows() && fits; ++i) {
      const int j = order[static_cast<std::size_t>(i)];
      if (j >= points.rows()) continue;
      const double distance = (points.row(j) - wanted.row(i)).norm();
      fits = distance <= within;
      ++pairs;
      sum += distance;
    }
    if (fits && (pairs > best.first || (pairs == best.first && sum < best.second)))
      best = {pairs, sum};
  } while (std::ranges::next_permutation(order).found);
  return best;
}

}  // namespace

TEST_CASE("most points are matched, and of those choices the nearest ones") {
  Random random(3);
  for (int trial = 0; trial < 150; ++trial) {
    const PlanePoints points = random_points(random, static_cast<Index>(random.below(4)), 40);
    const PlanePoints wanted = random_points(random, static_cast<Index>(1 + random.below(3)), 40);
    const double within = random.uniform(3.0, 40.0);
    const Matches matches = match_points(points, wanted, within);
    int pairs = 0;
    double sum = 0.0;
    std::vector<bool> taken(static_cast<std::size_t>(points.rows()), false);
    for (std::size_t i = 0; i < matches.index.size(); ++i) {
      const int j = matches.index[i];
      if (j < 0) continue;
      CHECK_FALSE(taken[static_cast<std::size_t>(j)]);
      taken[static_cast<std::size_t>(j)] = true;
      CHECK(matches.distance[i] <= within);
      ++pairs;
      sum += matches.distance[i];
    }
    const auto best = best_by_trying(points, wanted, within);
    CHECK(pairs == best.first);
    CHECK(sum == doctest::Approx(best.second).epsilon(1e-12));
    CHECK(matches.lost().size() == matches.index.size() - static_cast<std::size_t>(pairs));
  }
}

TEST_CASE("hundreds of points that moved a little are found in whatever order they come") {
  Random random(5);
  PlanePoints grid(400, 2);
  for (Index i = 0; i < 400; ++i)
    grid.row(i) << static_cast<double>(20 * (i % 20)), static_cast<double>(20 * (i / 20));
  std::vector<int> order(400);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = 399; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  PlanePoints moved(400, 2);
  for (Index i = 0; i < 400; ++i)
    moved.row(order[static_cast<std::size_t>(i)]) << grid(i, 0) + random.uniform(-6, 6),
        grid(i, 1) + random.uniform(-6, 6);
  CHECK(match_points(moved, grid, 12.0).index == order);
}

TEST_CASE("a tracker keeps labels, waits for points that are hidden, and says which are lost") {
  PlanePoints start(4, 2);
  start << 100, 100, 200, 100, 200, 200, 100, 200;
  PointTracker tracker(start, 12.0, 3);
  const auto picture = [&](int step, bool hides_second) {
    // Moves 9 pixels a picture; the points come in another order each time.
    PlanePoints now = start;
    now.col(0).array() += 9.0 * step;
    PlanePoints out(hides_second ? 3 : 4, 2);
    Index row = 0;
    for (Index i = 0; i < 4; ++i) {
      const Index label = (i + step) % 4;
      if (!hides_second || label != 1) out.row(row++) = now.row(label);
    }
    return out;
  };
  for (int step = 1; step <= 3; ++step) tracker.update(picture(step, false));
  CHECK((tracker.points().row(1) - Eigen::RowVector2d(227, 100)).norm() < 1e-12);
  for (int step = 4; step <= 6; ++step) tracker.update(picture(step, true));
  CHECK((tracker.points().row(1) - Eigen::RowVector2d(254, 100)).norm() < 1e-12);  // goes on
  CHECK(tracker.lost().empty());
  CHECK(tracker.missed() == std::vector<int>{0, 3, 0, 0});
  tracker.update(picture(7, true));
  CHECK(tracker.lost() == std::vector<int>{1});
  tracker.update(picture(8, false));  // where it was predicted
  CHECK(tracker.lost().empty());
  // A jump of a camera is followed by its prediction.
  PlanePoints far = start;
  far.col(1).array() += 300.0;
  tracker.update(far, far);
  CHECK(tracker.points() == far);
}

TEST_CASE("lists that cannot be matched are refused with their numbers") {
  const PlanePoints two = PlanePoints::Zero(2, 2);
  CHECK(refusal_of([&] { match_points(PlanePoints::Zero(501, 2), two, 5.0); }) ==
        "At most 500 points are matched, not 501 seen.");
  CHECK(refusal_of([&] { match_points(two, two, 0.0); }) ==
        "`within` is 0; it must be greater than zero.");
  CHECK(refusal_of([&] { match_points(two, PlanePoints::Constant(1, 2, std::nan("")), 5.0); }) ==
        "Element (0, 0) of `wanted` is nan; it must be a finite number.");
  PointTracker tracker(two, 5.0);
  CHECK(refusal_of([&] { tracker.update(two, PlanePoints::Zero(3, 2)); }) ==
        "2 points are tracked and 3 are predicted.");
  CHECK(match_points(PlanePoints(0, 2), two, 5.0).lost() == std::vector<int>{0, 1});
  CHECK(match_points(two, PlanePoints(0, 2), 5.0).index.empty());
}
