#include "armlet/interpreter/sorting.hpp"

#include <numeric>

#include "armlet/core/random.hpp"
#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

TEST_CASE("lists of all lengths are sorted as the C++ library sorts them, equals in their order") {
  VmOptions options;
  Vm vm(compiled("print(1)"), options);
  Random random(3);
  for (std::size_t n = 0; n < 400; n += n < 140 ? 1 : 37) {
    std::vector<std::pair<int, std::size_t>> items(n);
    for (std::size_t i = 0; i < n; ++i) items[i] = {static_cast<int>(random.below(20)), i};
    auto expected = items;
    const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::ranges::stable_sort(expected, less);
    auto room = items;
    auto order = less;
    REQUIRE(sort_stably(vm, std::span(items), std::span(room), order));
    CHECK(items == expected);
  }
}

TEST_CASE("sorting counts n log n steps and can be stopped") {
  VmOptions options;
  options.limits.steps = 20'000;
  Vm vm(compiled("print(1)"), options);
  std::vector<int> items(1'000'000);
  std::iota(items.rbegin(), items.rend(), 0);
  std::vector<int> room(items.size());
  const auto less = [](int a, int b) { return a < b; };
  CHECK(!sort_stably(vm, std::span(items), std::span(room), less));
}
