// Where a run pauses changes nothing: examples, scripts with tasks, random programs.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "armlet/backend/run_hash.hpp"
#include "armlet/core/random.hpp"
#include "library.hpp"
#include "random/program.hpp"
#include "random/robot_program.hpp"
#include "runs.hpp"

using namespace armlet;
using namespace armlet::oracle;
using namespace armlet::runs;

namespace {

// What a run shows of itself.
struct Shown {
  std::string output;
  std::string hash;
  std::string ending;
  std::uint64_t steps = 0;
  std::int64_t end_ns = 0;
  bool operator==(const Shown&) const = default;
};

// A program with a session of its own.
class Subject {
 public:
  Subject(const std::string& text, const fs::path& folder, RunLimits limits) {
    SessionOptions options = at_the_table();
    options.backends = {&hash_};
    options.limits = limits;
    options.load = files_beside(folder);
    options.output = [this](std::string_view piece) {
      shown_.output += piece;
      return std::string();
    };
    session_.emplace(library_engine(), std::move(options));
    compiles_ = session_->compile(text, "program.rbt");
  }

  [[nodiscard]] bool compiles() const { return compiles_; }

  // next  gives the budget of the next slice for the present time.
  template <class Next>
  Shown run(Next next) {
    hash_ = RunHash();
    shown_ = {};
    std::int64_t now_ns = 0;
    while (session_->run(next(now_ns)) == Progress::kPaused) now_ns = session_->host()->now_ns();
    const RunResult& result = session_->result();
    shown_.hash = hash_.text();
    shown_.steps = result.steps;
    shown_.end_ns = session_->host()->now_ns();
    if (result.error) shown_.ending = result.error->code + " " + result.error->message;
    return shown_;
  }

 private:
  RunHash hash_;
  Shown shown_;
  std::optional<Session> session_;
  bool compiles_ = false;
};

// Short runs step by step; long ones in as many slices as they can be in a test. Times in
// milliseconds, or a thousandth of a long run.
void check_slices(Subject& subject, std::uint64_t seed, std::uint64_t most_slices) {
  const Shown whole = subject.run([](std::int64_t) { return Budget{}; });
  const std::uint64_t steps = 1 + whole.steps / most_slices;
  CHECK(subject.run([&](std::int64_t) { return Budget{.until_ns = {}, .steps = steps}; }) == whole);
  const std::int64_t period =
      std::max<std::int64_t>(1'000'000, whole.end_ns / static_cast<std::int64_t>(most_slices));
  const auto every_period = [&](std::int64_t now) { return Budget{.until_ns = now + period}; };
  if (whole.end_ns > 0) CHECK(subject.run(every_period) == whole);
  Random random(seed);
  const auto at_random = [&](std::int64_t now) {
    Budget budget{.until_ns = {}, .steps = 1 + random.next() % (2 * steps + 7)};
    if (random.next() % 2 == 0)
      budget.until_ns = now + static_cast<std::int64_t>(random.next() % (2 * period));
    return budget;
  };
  CHECK(subject.run(at_random) == whole);
}

void check_files(const char* folder) {
  const std::vector<fs::path> files = programs_below(folder);
  CHECK(files.size() > 20);
  int ran = 0;
  for (const fs::path& file : files) {
    CAPTURE(file);
    Subject subject(text_of(file), file.parent_path(), {.steps = 2'000'000});
    if (!subject.compiles()) continue;
    ++ran;
    check_slices(subject, 1, 5000);
  }
  CHECK(ran > 20);
}

}  // namespace

TEST_CASE("examples send the same events in slices of any size") { check_files("examples"); }

TEST_CASE("scripts with tasks send the same events in slices of any size") {
  check_files("tests/scripts/tasks");
}

TEST_CASE("2,000 random programs with tasks do the same in slices of any size") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 2000);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    Subject subject(RandomProgram(number).with_tasks().text(), {},
                    {.steps = 20'000, .call_depth = 60});
    REQUIRE(subject.compiles());
    check_slices(subject, number, 2000);
  }
}

TEST_CASE("random programs that move robots send the same events in slices of any size") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 100);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    Subject subject(RobotProgram(number).text(), {}, {.steps = 200'000});
    REQUIRE(subject.compiles());
    check_slices(subject, number, 2000);
  }
}
