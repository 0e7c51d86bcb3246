#include "check/scopes/variable_set.hpp"

#include <doctest/doctest.h>

#include <deque>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace armlet::lang;

TEST_CASE("sets of variables do what std::set does") {
  std::mt19937 random(7);
  std::deque<hir::Variable> variables(100);
  using Plain = std::set<const hir::Variable*>;
  std::vector<std::pair<VariableSet, Plain>> sets(8);
  const auto pick = [&](std::size_t n) { return random() % n; };
  for (int step = 0; step < 20'000; ++step) {
    auto& [set, plain] = sets[pick(sets.size())];
    const auto& [other, other_plain] = sets[pick(sets.size())];
    const hir::Variable* variable = &variables[pick(variables.size())];
    switch (pick(8)) {
      case 0:
        set.unite(other);
        plain.merge(Plain(other_plain));
        break;
      case 1: {
        set.intersect(other);
        Plain both;
        for (const hir::Variable* v : plain) {
          if (other_plain.contains(v)) both.insert(v);
        }
        plain = both;
        break;
      }
      case 2:
        set = other;
        plain = Plain(other_plain);
        break;
      case 3:
      case 4:
        set.erase(variable);
        plain.erase(variable);
        break;
      default:
        set.insert(variable);
        plain.insert(variable);
        break;
    }
    REQUIRE(set.empty() == plain.empty());
    for (const hir::Variable& v : variables) REQUIRE(set.contains(&v) == plain.contains(&v));
  }
}
