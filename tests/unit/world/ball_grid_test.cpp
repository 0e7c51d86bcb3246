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
