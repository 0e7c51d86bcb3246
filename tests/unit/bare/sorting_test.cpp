// The sort of the build for pages, natively.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "missing_sorting.hpp"

namespace {

struct Less {
  bool operator()(const std::pair<int, int>& a, const std::pair<int, int>& b) const {
    return a.first < b.first;
  }
};

}  // namespace

TEST_CASE("rows of any length are in order, and what is alike stays as it stood") {
  std::mt19937 generator(5);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::pair<int, int>> row(generator() % 200);
    const auto kinds = 1 + generator() % 50;
    for (int i = 0; i < static_cast<int>(row.size()); ++i)
      row[static_cast<std::size_t>(i)] = {static_cast<int>(generator() % kinds), i};
    std::vector<std::pair<int, int>> expected = row;
    std::stable_sort(expected.begin(), expected.end(), Less{});
    std::ranges::missing::sort(row.begin(), row.end(), Less{});
    CHECK(row == expected);
  }
}

// Finding where each element of one long cycle has gone must not go through all before it.
TEST_CASE("a million elements that are in order but for one end soon") {
  constexpr int kCount = 1'000'000;
  for (const bool at_end : {true, false}) {
    std::vector<int> row;
    for (int i = 0; i < kCount; ++i) row.push_back((i + (at_end ? 1 : kCount - 1)) % kCount);
    std::ranges::missing::sort(row.begin(), row.end(), [](int a, int b) { return a < b; });
    CHECK(std::is_sorted(row.begin(), row.end()));
  }
}
