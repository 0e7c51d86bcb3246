#include "armlet/core/platform.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <new>

using namespace armlet;

TEST_CASE("reserved memory can be much more than there is, and is given back") {
  ReservedMemory memory(std::size_t{1} << 40U);
  auto* bytes = static_cast<char*>(memory.begin());
  bytes[0] = bytes[std::size_t{1} << 39U] = 'x';
  memory.give_back(4096);
  CHECK(bytes[0] == 'x');
  CHECK(bytes[std::size_t{1} << 39U] == 0);
  CHECK(reserves_for_free());
  CHECK_THROWS_AS(ReservedMemory(~std::size_t{0} / 2), std::bad_alloc);
}

TEST_CASE("an alarm rings once its time has passed, and not when it is gone before") {
  std::atomic<int> rung = 0;
  {
    const std::int64_t start = steady_time_ns();
    const Alarm alarm(2'000'000, [&] { ++rung; });
    while (rung == 0) yield_thread();
    CHECK(steady_time_ns() - start >= 2'000'000);
  }
  CHECK(rung == 1);
  {
    const Alarm alarm(3'600'000'000'000, [&] { ++rung; });
  }
  CHECK(rung == 1);
}

TEST_CASE("a library is loaded by name, and what it lacks is null") {
  const LoadedLibrary mathematics("libm.so.6");
  auto* cosine = reinterpret_cast<double (*)(double)>(mathematics.find("cos"));
  REQUIRE(static_cast<bool>(cosine));
  CHECK(cosine(0.0) == 1.0);
  CHECK(mathematics.find("armlet_has_no_such_function") == nullptr);
  CHECK(LoadedLibrary("libarmlet_is_not_there.so").find("cos") == nullptr);
}
