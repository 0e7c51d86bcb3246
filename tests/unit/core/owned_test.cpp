#include "armlet/core/owned.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace armlet;

TEST_CASE("a copy of an owned value is a value of its own, and a move keeps its address") {
  Owned<std::string> first(std::string("one"));
  Owned<std::string> second = first;
  *second += " more";
  CHECK(*first == "one");
  CHECK(*second == "one more");
  const std::string* address = &*first;
  std::vector<Owned<std::string>> list;
  list.push_back(std::move(first));
  for (int i = 0; i < 100; ++i) list.emplace_back(std::string("other"));
  CHECK(&*list.front() == address);
  list.erase(list.begin() + 1);
  list[0] = second;
  CHECK(*list[0] == "one more");
  CHECK(list[0]->size() == 8);
}
