#include "armlet/world/ball_grid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/random.hpp"

using namespace armlet;
using Eigen::Vector3d;

TEST_CASE("a grid finds the balls that a search through all finds, in the order of their numbers") {
  Random random(5);
  for (const auto space : {BallGrid::Space::kWhole, BallGrid::Space::kColumns}) {
    BallGrid grid(space);
    std::vector<std::pair<Vector3d, double>> balls;
    std::vector<bool> there;
    const auto some = [&](double most) {
      return Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                      random.uniform(-most, most));
    };
    // From a tenth of a millimetre to a hundred metres, and points.
    const auto size = [&] {
      return random.uniform(0, 1) < 0.05 ? 0.0 : std::pow(10.0, random.uniform(-4, 2));
    };
    for (std::uint32_t round = 0; round < 3000; ++round) {
      if (round % 3 == 2) {
        const auto i =
            static_cast<std::uint32_t>(random.uniform(0, static_cast<double>(balls.size())));
        if (random.uniform(0, 1) < 0.5) {
          grid.take(i);
          there[i] = false;
        } else {
          balls[i] = {some(round % 2 ? 1.0 : 1e4), size()};
          grid.put(i, balls[i].first, balls[i].second);
          there[i] = true;
        }
      } else {
        balls.emplace_back(some(2.0), size());
        there.push_back(true);
        grid.put(static_cast<std::uint32_t>(balls.size() - 1), balls.back().first,
                 balls.back().second);
      }
      const Vector3d middle = some(2.0);
      const double radius = size();
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < balls.size(); ++i) {
        Vector3d apart = balls[i].first - middle;
        if (space == BallGrid::Space::kColumns) apart.z() = 0.0;
        if (there[i] && apart.norm() <= balls[i].second + radius) expected.push_back(i);
      }
      REQUIRE(grid.touching(middle, radius) == expected);
    }
    CHECK(grid.size() == static_cast<std::size_t>(std::ranges::count(there, true)));
  }
}

TEST_CASE("of balls with cores a grid leaves out those whose cores overlap that of the query") {
  Random random(6);
  for (const auto space : {BallGrid::Space::kWhole, BallGrid::Space::kColumns}) {
    BallGrid grid(space);
    struct Ball {
      Vector3d middle;
      double radius = 0.0, core = BallGrid::kNoCore;
      bool there = true;
    };
    std::vector<Ball> balls;
    const auto some = [&](double most) {
      return Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                      random.uniform(-most, most));
    };
    // Nearly in one position, in heaps of every width, and far apart.
    const auto ball = [&] {
      Ball made{some(std::pow(10.0, random.uniform(-6, 0)))};
      made.radius = std::pow(10.0, random.uniform(-3, 0));
      if (random.below(4) > 0) made.core = made.radius * random.uniform(0.0, 1.0);
      return made;
    };
    for (std::uint32_t round = 0; round < 3000; ++round) {
      const bool is_new = balls.empty() || round % 3 != 2;
      const auto i = static_cast<std::uint32_t>(is_new ? balls.size() : random.below(balls.size()));
      if (is_new) balls.emplace_back();
      balls[i] = ball();
      balls[i].there = is_new || random.below(2) == 0;
      if (balls[i].there)
        grid.put(i, balls[i].middle, balls[i].radius, balls[i].core);
      else
        grid.take(i);
      const Ball query = ball();
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < balls.size(); ++k) {
        const Vector3d whole = balls[k].middle - query.middle;
        Vector3d apart = whole;
        if (space == BallGrid::Space::kColumns) apart.z() = 0.0;
        const bool touches = apart.norm() <= balls[k].radius + query.radius;
        if (balls[k].there && touches && !(whole.norm() < balls[k].core + query.core))
          expected.push_back(k);
      }
      REQUIRE(grid.touching(query.middle, query.radius, query.core) == expected);
    }
    CHECK(grid.size() == static_cast<std::size_t>(std::ranges::count(balls, true, &Ball::there)));
  }
}
