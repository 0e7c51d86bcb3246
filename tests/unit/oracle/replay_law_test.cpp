// Going back changes nothing: examples, scripts with tasks, random programs, stopped ones.
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "library.hpp"
#include "random/program.hpp"
#include "runs.hpp"
#include "tape.hpp"

using namespace armlet;
using namespace armlet::oracle;
using namespace armlet::runs;

namespace {

// What a run shows of itself.
struct ToldRun {
  std::vector<std::uint64_t> events;
  std::string ending;
  std::uint64_t steps = 0;
  std::int64_t end_ns = 0;
  bool operator==(const ToldRun&) const = default;
};

class Traveller {
 public:
  Traveller(const std::string& text, const fs::path& folder, RunLimits limits) {
    SessionOptions options = at_the_table();
    options.backends = {&tape_};
    options.limits = limits;
    options.load = files_beside(folder);
    session_.emplace(library_engine(), std::move(options));
    compiles_ = session_->compile(text, "program.rbt");
  }

  [[nodiscard]] bool compiles() const { return compiles_; }
  [[nodiscard]] Session& session() { return *session_; }

  // To the end, in slices of so many steps.
  ToldRun run(std::uint64_t steps) {
    while (session_->run({.until_ns = {}, .steps = steps}) == Progress::kPaused) {
    }
    const RunResult& result = session_->result();
    CHECK(tape_.gaps() == 0);
    return {tape_.hashes(), result.error ? result.error->code + result.error->message : "",
            result.steps, session_->host()->now_ns()};
  }

 private:
  Tape tape_;
  std::optional<Session> session_;
  bool compiles_ = false;
};

// Runs, goes to random times and on, in slices of random sizes.
void check_going(Traveller& subject, std::uint64_t seed, int times) {
  const ToldRun whole = subject.run(Budget::kNoLimit);
  Random random(seed);
  Session& session = subject.session();
  for (int i = 0; i < times; ++i) {
    const auto t_ns =
        static_cast<std::int64_t>(random.next() % (static_cast<std::uint64_t>(whole.end_ns) + 1));
    CAPTURE(t_ns);
    REQUIRE(session.go_to(t_ns));
    CHECK(session.host()->now_ns() == t_ns);
    // A little further, and back once more.
    if (i % 3 == 0 && session.result().status == Progress::kPaused) {
      session.run({.until_ns = {}, .steps = 1 + random.next() % 100});
      REQUIRE(session.go_to(t_ns / 2));
    }
    const std::uint64_t steps = i % 2 == 0 ? Budget::kNoLimit : 1 + whole.steps / 7;
    CHECK(subject.run(steps) == whole);
  }
  CHECK(session.runs().empty());
}

void check_going_in(const char* folder, int times) {
  const std::vector<fs::path> files = programs_below(folder);
  int ran = 0;
  for (const fs::path& file : files) {
    CAPTURE(file);
    Traveller subject(text_of(file), file.parent_path(), {.steps = 2'000'000});
    if (!subject.compiles()) continue;
    ++ran;
    check_going(subject, static_cast<std::uint64_t>(ran), times);
  }
  CHECK(ran > 20);
}

// A run that somebody stops: with its log another session stops at the same instant.
void check_stopping(const std::string& text, std::uint64_t seed) {
  const RunLimits limits{.steps = 20'000, .call_depth = 60};
  Traveller first(text, {}, limits);
  Random random(seed);
  const std::uint64_t after = 1 + random.next() % 300;
  if (first.session().run({.until_ns = {}, .steps = after}) != Progress::kPaused) return;
  first.session().cancel();
  const ToldRun stopped = first.run(1 + random.next() % 5000);
  const Result<std::string> bytes = write_log(first.session().log());
  REQUIRE(bytes.ok());
  const Result<SessionLog> log = read_log(*bytes);
  REQUIRE(log.ok());
  Traveller second("", {}, limits);
  REQUIRE(second.session().replay(*log));
  CHECK(second.run(Budget::kNoLimit) == stopped);
  CHECK(second.session().log().entry.cancelled == log->entry.cancelled);
}

}  // namespace

TEST_CASE("examples go on the same from 50 random times") { check_going_in("examples", 50); }

TEST_CASE("scripts with tasks go on the same from 50 random times") {
  check_going_in("tests/scripts/tasks", 50);
}

TEST_CASE("2,000 random programs go on the same from random times, and stop the same again") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 2000);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    const std::string text = RandomProgram(number).text();
    Traveller subject(text, {}, {.steps = 20'000, .call_depth = 60});
    REQUIRE(subject.compiles());
    check_going(subject, number, 3);
    check_stopping(text, number);
  }
}
