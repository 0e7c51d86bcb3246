#include "client/cache.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "temporary_folder.hpp"

using namespace armlet;
using namespace armlet::mesh;

namespace {

namespace fs = std::filesystem;

Sibling nothing(const std::string&) { return {Say::kAbsent, {}}; }

// A folder of conversions, each of 1000 bytes, that may hold three of them.
struct Kept {
  [[nodiscard]] Cache cache(char key) const {
    return {place.path().string(), std::string(1, key), 3'500};
  }
  // `age`: how long ago its files were used, s.
  void keep(char key, int age) const {
    cache(key).keep({}, std::string(1000, key));
    for (const auto& each : fs::directory_iterator(place.path())) {
      const auto written = fs::last_write_time(each);
      if (fs::file_time_type::clock::now() - written < std::chrono::seconds(5))
        fs::last_write_time(each, written - std::chrono::seconds(age));
    }
  }
  [[nodiscard]] bool has(char key) const {
    const auto found = cache(key).find(nothing);
    return found && *found == std::string(1000, key);
  }
  [[nodiscard]] std::uintmax_t size() const {
    std::uintmax_t sum = 0;
    for (const auto& each : fs::directory_iterator(place.path())) sum += each.file_size();
    return sum;
  }

  TemporaryFolder place;
};

}  // namespace

TEST_CASE("what was not used for the longest time makes room") {
  Kept kept;
  kept.keep('a', 400);
  kept.keep('b', 300);
  kept.keep('c', 200);
  CHECK(kept.size() > 3'000);
  CHECK(kept.has('a'));  // it is used now
  kept.keep('d', 100);
  CHECK(kept.size() <= 3'500);
  CHECK(kept.has('a'));
  CHECK_FALSE(kept.has('b'));
  CHECK(kept.has('c'));
  CHECK(kept.has('d'));
}

TEST_CASE("what is too large is not kept, and what is not of the cache stays") {
  Kept kept;
  { std::ofstream(kept.place.path() / "mine.txt") << std::string(10'000, 'x'); }
  kept.keep('a', 10);
  CHECK(kept.has('a'));
  kept.cache('b').keep({}, std::string(4'000, 'b'));
  CHECK_FALSE(kept.cache('b').find(nothing));
  CHECK(fs::exists(kept.place.path() / "mine.txt"));
}
