// Going back changes nothing: examples, scripts with tasks, random programs, stopped ones.
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "library.hpp"
#include "random/program.hpp"
#include "random/robot_program.hpp"
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
  Traveller(const std::string& text, const fs::path& folder, RunLimits limits)
      : Traveller(folder, limits) {
    compiles_ = session_->compile(text, "program.rbt");
  }
  Traveller(const fs::path& folder, RunLimits limits) {
    SessionOptions options = at_the_table();
    options.backends = {&tape_};
    options.limits = limits;
    options.load = files_beside(folder);
    session_.emplace(library_engine(), std::move(options));
  }

  [[nodiscard]] bool compiles() const { return compiles_; }
  [[nodiscard]] Session& session() { return *session_; }
  [[nodiscard]] const std::vector<std::uint64_t>& events() const { return tape_.hashes(); }
  void take_back(std::size_t events) { tape_.take_back(events); }

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
  CHECK(second.session().log().entries.back().cancelled == log->entries.back().cancelled);
}

// ---- entries

// The statements of a text, some at a time: each piece is a complete entry.
std::vector<std::string> cut(const std::string& text, Random& random) {
  std::vector<std::string> pieces;
  std::string piece;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    piece += text.substr(at, end - at);
    at = end;
    const std::string_view next = std::string_view(text).substr(at, text.find('\n', at) - at);
    if (random.below(3) == 0 && is_complete(piece, next))
      pieces.push_back(std::exchange(piece, {}));
  }
  if (!piece.empty()) pieces.push_back(piece);
  return pieces;
}

// All that is known to come, one entry after the other.
void run_all(Session& session, std::uint64_t steps) {
  do {
    while (session.run({.until_ns = {}, .steps = steps}) == Progress::kPaused) {
    }
  } while (session.to_come() > 0);
}

struct ToldSession {
  std::vector<std::uint64_t> events;
  std::string log;
  bool operator==(const ToldSession&) const = default;
};

// A text in pieces, some of which fail and count as if they had not been.
void check_entries(const std::string& text, std::uint64_t seed) {
  const RunLimits limits{.steps = 20'000, .call_depth = 60};
  Random random(seed);
  const std::vector<std::string> pieces = cut(text, random);
  Traveller first({}, limits);
  Session& session = first.session();
  const auto enter = [&](const std::string& piece, std::uint64_t steps) {
    if (!session.submit(piece, "line")) return;
    const std::size_t entries = session.entries().size();
    const std::size_t events = first.events().size();
    run_all(session, steps);
    if (session.entries().size() == entries) first.take_back(events);
  };
  for (const std::string& piece : pieces) {
    if (random.below(4) == 0) enter(piece + "\nlet lost = [1, 2][7]\n", 1 + random.below(500));
    enter(piece, 1 + random.below(2000));
    if (random.below(4) == 0) session.set_signal("gate", random.below(2) == 0);
  }
  if (session.entries().empty()) return;
  const auto told = [](Traveller& one) {
    const Result<std::string> log = write_log(one.session().log());
    REQUIRE(log.ok());
    return ToldSession{one.events(), *log};
  };
  const ToldSession whole = told(first);
  const std::int64_t end_ns = session.host()->now_ns();
  // Another session, from the log.
  Traveller second({}, limits);
  REQUIRE(second.session().replay(read_log(whole.log).value()));
  run_all(second.session(), 1 + random.below(500));
  CHECK(told(second).events == whole.events);
  CHECK(told(second).log == whole.log);
  // To times of any entry, back by some, and on.
  for (int i = 0; i < 3; ++i) {
    const auto t_ns =
        static_cast<std::int64_t>(random.next() % (static_cast<std::uint64_t>(end_ns) + 1));
    CAPTURE(t_ns);
    REQUIRE(session.go_to(t_ns));
    CHECK(session.host()->now_ns() == t_ns);
    if (session.result().status == Progress::kPaused) run_all(session, 1 + random.below(100));
    const std::size_t back = random.below(session.entries().size());
    CHECK(session.undo(back) == back);
    if (random.below(2) == 0) static_cast<void>(session.redo(1));
    if (session.to_come() > 0) run_all(session, 1 + random.below(3000));
    CHECK(told(first).events == whole.events);
    CHECK(told(first).log == whole.log);
  }
  CHECK(session.runs().empty());
}

}  // namespace

TEST_CASE("examples go on the same from 50 random times") { check_going_in("examples", 50); }

TEST_CASE("scripts with tasks go on the same from 50 random times") {
  check_going_in("tests/scripts/tasks", 50);
}

TEST_CASE(
    "2,000 random programs with tasks go on the same from 50 random times, and stop the same") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 2000);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    const std::string text = RandomProgram(number).with_tasks().text();
    Traveller subject(text, {}, {.steps = 20'000, .call_depth = 60});
    REQUIRE(subject.compiles());
    check_going(subject, number, 50);
    check_stopping(text, number);
  }
}

TEST_CASE("random programs that move robots go on the same from 50 random times") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 40);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    const std::string text = RobotProgram(number).text();
    Traveller subject(text, {}, {.steps = 20'000, .call_depth = 60});
    REQUIRE(subject.compiles());
    check_going(subject, number, 50);
    check_stopping(text, number);
  }
}

TEST_CASE("examples and scripts with tasks, line by line, are sessions that go anywhere") {
  // Each folder counts on its own, so that a new example does not cut the scripts differently.
  for (auto [folder, seed] : {std::pair{"examples", std::uint64_t{0}},
                              std::pair{"tests/scripts/tasks", std::uint64_t{100}}}) {
    for (const fs::path& file : programs_below(folder)) {
      CAPTURE(file);
      check_entries(text_of(file), ++seed);
    }
  }
}

TEST_CASE("scripts with watches, each cut twenty times, are sessions that go anywhere") {
  for (const fs::path& file : programs_below("tests/scripts/tasks/watches")) {
    CAPTURE(file);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      check_entries(text_of(file), seed);
    }
  }
}

TEST_CASE("random programs cut into entries go on the same from anywhere, and from their log") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 500);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    check_entries(RandomProgram(number).text(), number);
  }
}
