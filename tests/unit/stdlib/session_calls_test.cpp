// Functions of a program that a host begins after its end, and sessions of many entries once more.
#include <doctest/doctest.h>

#include <string>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "library.hpp"
#include "refusal_of.hpp"
#include "tape.hpp"

using namespace armlet;

namespace {

constexpr std::int64_t kCallMs = 1'000'000;

const char* const kPressed = R"(
var clearance = 80mm
var presses: string[] = []
fn pick(name: string, times: int) -> int {
    presses.push(name)
    for (i in range(times)) {
        moveJ(home() + [0.1 * (i + 1), 0, 0, 0], time: 1s)
        moveJ(home(), time: 0.5s)
    }
    print("picked", presses, clearance)
    return times
}
fn fail() { moveJ(home() + [0.3, 0, 0, 0], time: 1s); assert(false) }
moveJ(home() + [0.2, 0, 0, 0], time: 0.5s)
moveJ(home(), time: 0.5s)
)";

// A session that keeps what it prints and sends.
struct Called {
  explicit Called(bool markers = false) : session(library_engine(), options(markers)) {}
  SessionOptions options(bool markers) {
    SessionOptions made = at_the_table();
    made.open = true;
    made.markers = markers;
    made.backends = {&tape};
    made.output = [this](std::string_view text) {
      printed += text;
      return std::string();
    };
    return made;
  }
  // A program, or the same text as an entry, and two presses with a slider moved between them.
  void use(bool as_entry) {
    REQUIRE((as_entry ? session.submit(kPressed, "p.rbt") : session.compile(kPressed, "p.rbt")));
    REQUIRE(session.run().status == Progress::kDone);
    session.begin_call("pick", {Value("a"), Value(2)});
    CHECK(session.host()->now_ns() == 1000 * kCallMs);
    REQUIRE(session.run({.until_ns = 1500 * kCallMs}) == Progress::kPaused);
    session.set("clearance", Value(25.0, "mm"));
    REQUIRE(session.run(Budget{}) == Progress::kDone);
    session.set_signal("gate", true);
    session.begin_call("pick", {Value("b"), Value(1)});
    while (session.run({.until_ns = {}, .steps = 2}) == Progress::kPaused) {
    }
    CHECK(session.result().status == Progress::kDone);
    CHECK(session.host()->now_ns() == 5500 * kCallMs);
    CHECK(printed == "picked [\"a\"] 25 mm\npicked [\"a\", \"b\"] 25 mm\n");
    CHECK(session.entries().size() == 3);
    CHECK(session.entries()[1].moves == 4);
  }

  Tape tape;
  std::string printed;
  Session session;
};

SessionLog through_a_file(const Session& session) {
  const Result<std::string> bytes = write_log(session.log());
  REQUIRE_MESSAGE(bytes.ok(), bytes.error().message);
  Result<SessionLog> read = read_log(*bytes);
  REQUIRE_MESSAGE(read.ok(), read.error().message);
  CHECK(write_log(*read).value() == *bytes);
  return std::move(read).value();
}

void run_all(Session& session, std::uint64_t steps) {
  do {
    while (session.run({.until_ns = {}, .steps = steps}) == Progress::kPaused) {
    }
  } while (session.to_come() > 0);
}

}  // namespace

TEST_CASE("calls in slices are entries: another session takes them again from the log") {
  for (const bool as_entry : {false, true}) {
    CAPTURE(as_entry);
    Called first;
    first.use(as_entry);
    const SessionLog log = through_a_file(first.session);
    REQUIRE(log.entries.size() == 3);
    CHECK(log.entries[1].kind == EntryKind::kCall);
    CHECK(log.entries[1].inputs.size() == 2);
    for (const std::uint64_t steps : {Budget::kNoLimit, std::uint64_t{3}}) {
      Called second(steps == 3);
      REQUIRE(second.session.replay(log));
      run_all(second.session, steps);
      CHECK(second.tape.hashes() == first.tape.hashes());
      CHECK(second.printed == first.printed);
      CHECK(write_log(second.session.log()).value() == write_log(log).value());
    }
  }
}

TEST_CASE("a session goes to any time of any entry and on") {
  for (const bool as_entry : {false, true}) {
    CAPTURE(as_entry);
    Called run;
    run.use(as_entry);
    const auto events = run.tape.hashes();
    for (const std::int64_t t : {0, 250, 999, 1000, 1200, 2700, 4000, 4001, 5500}) {
      CAPTURE(t);
      REQUIRE(run.session.go_to(t * kCallMs));
      CHECK(run.session.host()->now_ns() == t * kCallMs);
      while (run.session.to_come() > 0) run_all(run.session, Budget::kNoLimit);
      CHECK(run.tape.hashes() == events);
      CHECK(run.session.entries().size() == 3);
    }
    REQUIRE(run.session.go_to(0, 1000 * kCallMs));
    CHECK(run.session.to_come() == 2);
    CHECK(run.session.redo(1) == 1);
    CHECK(run.session.vm()->global("presses").get<Value::List>().size() == 1);
    CHECK(run.session.runs().empty());
  }
}

TEST_CASE("a call at an earlier end is another run, and the first one is kept") {
  Called run;
  run.use(false);
  const std::string before = write_log(run.session.log()).value();
  CHECK(run.session.undo(1) == 1);
  run.session.begin_call("pick", {Value("c"), Value(2)});
  CHECK(run.session.run().status == Progress::kDone);
  CHECK(run.session.host()->now_ns() == 7000 * kCallMs);
  CHECK(run.session.to_come() == 0);
  REQUIRE(run.session.runs().size() == 1);
  CHECK(write_log(run.session.runs()[0]).value() == before);
  // Back and forth between the two.
  const std::string after = write_log(run.session.log()).value();
  for (const std::string& now : {before, after, before, after}) {
    REQUIRE(run.session.take_up(0));
    CHECK(write_log(run.session.log()).value() == now);
    CHECK(run.session.host()->now_ns() == (now == before ? 5500 : 7000) * kCallMs);
  }
  CHECK(refusal_of([&] { static_cast<void>(run.session.take_up(1)); }).find("1 runs") !=
        std::string::npos);
  // An input in an entry that has others behind it.
  REQUIRE(run.session.go_to(1200 * kCallMs));
  run.session.set("clearance", Value(1.0, "mm"));
  CHECK(run.session.to_come() == 1);
  CHECK(run.session.runs().size() == 2);
  CHECK(run.session.run().status == Progress::kDone);
  CHECK(run.session.to_come() == 0);
}

TEST_CASE("a call that fails or is stopped leaves what it did, also once more") {
  Called run;
  REQUIRE(run.session.compile(kPressed, "p.rbt"));
  REQUIRE(run.session.run().status == Progress::kDone);
  run.session.begin_call("fail", {});
  CHECK(run.session.run().status == Progress::kFailed);
  CHECK(run.session.host()->now_ns() == 2000 * kCallMs);
  run.session.begin_call("pick", {Value("a"), Value(1)});
  CHECK(run.session.run({.until_ns = 2300 * kCallMs}) == Progress::kPaused);
  run.session.cancel();
  CHECK(run.session.run().status == Progress::kCancelled);
  const std::int64_t stopped_ns = run.session.host()->now_ns();
  run.session.begin_call("pick", {Value("b"), Value(1)});
  CHECK(run.session.run().status == Progress::kDone);
  Called again;
  REQUIRE(again.session.replay(through_a_file(run.session)));
  run_all(again.session, 5);
  CHECK(again.tape.hashes() == run.tape.hashes());
  CHECK(again.session.undo(1) == 1);
  CHECK(again.session.host()->now_ns() == stopped_ns);
  CHECK(again.session.result().status == Progress::kCancelled);
}

TEST_CASE("calls of programs with markers run by statements, and step back into earlier entries") {
  Called run(true);
  run.use(true);
  const auto events = run.tape.hashes();
  int steps = 0;
  while (run.session.entries().size() > 1 || run.session.host()->now_ns() > 500 * kCallMs) {
    REQUIRE(run.session.step_back());
    REQUIRE(++steps < 60);
  }
  CHECK(steps > 10);
  run_all(run.session, Budget::kNoLimit);
  CHECK(run.tape.hashes() == events);
  CHECK(run.session.undo(2) == 2);
  run.session.begin_call("pick", {Value("a"), Value(2)});
  CHECK(run.session.set_breakpoints({{.line = 11}}).size() == 1);
  CHECK(run.session.run(Budget{}) == Progress::kPaused);
  CHECK(run.session.host()->now_ns() == 4000 * kCallMs);
}

TEST_CASE("what cannot be begun is refused, and all stays as it was") {
  Called run;
  CHECK(refusal_of([&] { run.session.begin_call("pick", {}); }) ==
        "A session cannot call a function before its first run.");
  REQUIRE(run.session.compile(kPressed, "p.rbt"));
  REQUIRE(run.session.run({.until_ns = 100 * kCallMs}) == Progress::kPaused);
  CHECK(refusal_of([&] { run.session.begin_call("pick", {}); }).find("under way") !=
        std::string::npos);
  REQUIRE(run.session.run().status == Progress::kDone);
  const std::string before = write_log(run.session.log()).value();
  CHECK(refusal_of([&] { run.session.begin_call("pack", {}); }).find("pack") != std::string::npos);
  CHECK(refusal_of([&] { run.session.begin_call("pick", {Value("a")}); }).find("2 parameters") !=
        std::string::npos);
  CHECK(refusal_of([&] {
          run.session.begin_call("pick", {Value("a"), Value(1.5, "m")});
        }).find("`times`") != std::string::npos);
  CHECK(write_log(run.session.log()).value() == before);
  CHECK(run.session.to_come() == 0);
  CHECK(refusal_of([&] { static_cast<void>(run.session.go_to(1, 0)); }).find("1 entries") !=
        std::string::npos);
  run.session.begin_call("pick", {Value("a"), Value(1)});
  CHECK(run.session.run().status == Progress::kDone);
}
