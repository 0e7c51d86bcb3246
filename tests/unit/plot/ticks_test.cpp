#include "armlet/plot/ticks.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"

using namespace armlet;
using Labels = std::vector<std::string>;

TEST_CASE("ticks are round and labelled with equal decimals") {
  CHECK(make_ticks(0, 1, 5, false, true).labels == Labels{"0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(make_ticks(-3, 7, 5, false, true).labels == Labels{"-4", "-2", "0", "2", "4", "6", "8"});
  CHECK(make_ticks(0.013, 0.0172, 4, false, false).labels ==
        Labels{"0.013", "0.014", "0.015", "0.016", "0.017"});
  CHECK(make_ticks(0, 45000, 5, false, true).labels ==
        Labels{"0", "10000", "20000", "30000", "40000", "50000"});
}

TEST_CASE("degrees are counted in parts of a turn") {
  CHECK(make_ticks(-180, 180, 8, true, true).labels ==
        Labels{"-180", "-135", "-90", "-45", "0", "45", "90", "135", "180"});
  CHECK(make_ticks(0, 60, 6, true, true).labels == Labels{"0", "10", "20", "30", "40", "50", "60"});
}

TEST_CASE("values that are all the same get room to either side") {
  for (const double value : {0.0, 5.0, -3e7, 1e300, 1e-300}) {
    CAPTURE(value);
    const Ticks ticks = make_ticks(value, value, 5, false, true);
    CHECK(ticks.lower < value);
    CHECK(ticks.upper > value);
    CHECK(ticks.at.size() >= 2);
  }
}

TEST_CASE("whatever the values, ticks are few, increase and enclose what was asked for") {
  Random random(61);
  for (int k = 0; k < 5000; ++k) {
    const double scale = std::pow(10.0, random.uniform(-250, 280));
    const double a = scale * random.uniform(-1, 1), b = scale * random.uniform(-1, 1);
    const double lower = std::min(a, b), upper = std::max(a, b);
    const int wanted = 2 + k % 9;
    const Ticks ticks = make_ticks(lower, upper, wanted, k % 3 == 0, true);
    CHECK(ticks.lower <= lower + 1e-9 * scale);
    CHECK(ticks.upper >= upper - 1e-9 * scale);
    CHECK(ticks.at.size() >= 2);
    CHECK(ticks.at.size() <= static_cast<std::size_t>(2 * wanted + 3));
    CHECK(ticks.at.size() == ticks.labels.size());
    for (std::size_t i = 1; i < ticks.at.size(); ++i) CHECK(ticks.at[i] > ticks.at[i - 1]);
    CHECK(std::isfinite(ticks.position(lower)));
  }
}
