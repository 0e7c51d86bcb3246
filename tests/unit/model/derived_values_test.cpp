#include "armlet/model/derived_values.hpp"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace armlet;

namespace {

// How often each value was made, and what its next makers do.
struct Source {
  mutable std::atomic<int> made = 0;
  mutable std::atomic<int> failures_left = 0;
  double number = 0.0;
  DerivedValues values;
};

struct Twice {
  double value;
  explicit Twice(const Source& source) : value(2.0 * source.number) { ++source.made; }
};

// Of the same size as Twice, made of another value of the same source.
struct TwiceAndOne {
  double value;
  explicit TwiceAndOne(const Source& source) : value(source.values.get<Twice>(source).value + 1.0) {
    ++source.made;
  }
};

struct Failing {
  explicit Failing(const Source& source) {
    if (source.failures_left-- > 0) throw std::runtime_error("not yet");
    ++source.made;
  }
};

template <int kNumber>
struct Numbered {
  int number = kNumber;
  explicit Numbered(const Source& source) { ++source.made; }
};

}  // namespace

TEST_CASE("there is one value of each type, made once and shared by copies") {
  Source source;
  source.number = 3.0;
  const DerivedValues before = source.values;
  const TwiceAndOne& first = source.values.get<TwiceAndOne>(source);
  const Twice& second = source.values.get<Twice>(source);
  CHECK(first.value == 7.0);
  CHECK(second.value == 6.0);
  const DerivedValues after = source.values;
  for (const DerivedValues* copy : {&before, &after}) {
    CHECK(&copy->get<TwiceAndOne>(source) == &first);
    CHECK(&copy->get<Twice>(source) == &second);
  }
  CHECK(source.made == 2);
  const DerivedValues others;
  CHECK(&others.get<Twice>(source) != &second);
  CHECK(source.made == 3);
}

TEST_CASE("a value that could not be made is made by the next call") {
  Source source;
  source.failures_left = 2;
  CHECK_THROWS_AS(source.values.get<Failing>(source), std::runtime_error);
  CHECK_THROWS_AS(source.values.get<Failing>(source), std::runtime_error);
  const Failing& made = source.values.get<Failing>(source);
  CHECK(&source.values.get<Failing>(source) == &made);
  CHECK(source.made == 1);
}

TEST_CASE("however many threads ask for many values, each is made once") {
  constexpr int kThreads = 8;
  for (int round = 0; round < 200; ++round) {
    Source source;
    std::atomic<int> waiting = kThreads;
    std::array<std::array<const void*, 5>, kThreads> seen{};
    std::vector<std::jthread> threads;
    for (auto& mine : seen) {
      threads.emplace_back([&] {
        --waiting;
        while (waiting > 0) std::this_thread::yield();
        const DerivedValues& values = source.values;
        mine = {&values.get<Numbered<1>>(source), &values.get<TwiceAndOne>(source),
                &values.get<Numbered<2>>(source), &values.get<Twice>(source),
                &values.get<Numbered<3>>(source)};
      });
    }
    threads.clear();
    for (const auto& others : seen) REQUIRE(others == seen[0]);
    REQUIRE(source.made == 5);
    REQUIRE(source.values.get<Numbered<2>>(source).number == 2);
  }
}
