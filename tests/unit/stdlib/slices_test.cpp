// A session that returns to the host's loop between slices.
#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/backend/recorder.hpp"
#include "armlet/core/error.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

const std::string kProgram = R"(
insertObj("cube")
let start = home()
every (40ms) { print("beat", now()) }
moveJ(start + [0.1, 0, 0, 0], time: 0.5s)
var s = 0.0
for (i in range(100)) { s = s + 0.1 * i }
print(s)
parallel {
    { moveJ(start, time: 0.4s) }
    { wait(0.1s); print("half way", now()) }
}
speedJ([0.1, 0, 0, 0], during: 0.1s)
)";

// What a backend writes of a run whose slices `next` gives.
template <class Next>
std::string trace_of(Next next, int* slices = nullptr) {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  SessionOptions made = at_the_table();
  made.backends = {backend.get()};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile(kProgram, "slices.rbt"));
  int count = 1;
  while (session.run(next(session)) == Progress::kPaused) ++count;
  REQUIRE(session.result().status == Progress::kDone);
  out << session.result().steps << " steps\n";
  if (slices != nullptr) *slices = count;
  return out.str();
}

}  // namespace

TEST_CASE("a session in slices sends the same events") {
  const std::string whole = trace_of([](Session&) { return Budget{}; });
  CHECK(whole.find("half way 0.6 s") != std::string::npos);
  int slices = 0;
  CHECK(trace_of([](Session&) { return Budget{.until_ns = {}, .steps = 1}; }, &slices) == whole);
  CHECK(slices >= 100);
  const auto frame = [](Session& session) {
    const std::int64_t now = session.host() == nullptr ? 0 : session.host()->now_ns();
    return Budget{.until_ns = now + 1'666'667};
  };
  CHECK(trace_of(frame, &slices) == whole);
  CHECK(slices > 500);
}

TEST_CASE("a session pauses while its robots come to rest") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile("speedJ([0.1, 0, 0, 0], during: 0.1s)", "rest.rbt"));
  REQUIRE(session.run({.until_ns = 110'000'000}) == Progress::kPaused);
  CHECK(session.host()->now_ns() == 110'000'000);
  CHECK(session.vm()->result().status == Progress::kDone);
  CHECK(session.host()->cell().is_moving(0));
  REQUIRE(session.run(Budget{}) == Progress::kDone);
  CHECK_FALSE(session.host()->cell().is_moving(0));
}

TEST_CASE("a run that is given up ends for its backends, once") {
  class Ends : public Backend {
   public:
    void on(const Event& event) override {
      if (std::holds_alternative<EndRun>(event)) ++count;
    }
    int count = 0;
  };
  Ends ends;
  SessionOptions made = at_the_table();
  made.backends = {&ends};
  {
    Session session(library_engine(), std::move(made));
    REQUIRE(session.compile(kProgram, "slices.rbt"));
    REQUIRE(session.run({.until_ns = 200'000'000}) == Progress::kPaused);
    CHECK(ends.count == 0);
    REQUIRE(session.compile("wait(1s)", "other.rbt"));
    CHECK(ends.count == 1);
    CHECK(session.vm() == nullptr);
    REQUIRE(session.run({.until_ns = 200'000'000}) == Progress::kPaused);
    CHECK(session.host()->now_ns() == 200'000'000);
  }
  CHECK(ends.count == 2);
}

TEST_CASE("cancelling between two slices stops the next one, and that run alone") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile("while (true) { wait(1s) }", "endless.rbt"));
  REQUIRE(session.run({.until_ns = 5'000'000'000}) == Progress::kPaused);
  session.cancel();
  CHECK(session.run(Budget{}) == Progress::kCancelled);
  CHECK(session.run({.until_ns = 2'000'000'000}) == Progress::kPaused);
}

TEST_CASE("what a program does when it is stopped is the same in slices") {
  const auto stopped = [](const Budget& slice) {
    std::ostringstream out;
    const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
    SessionOptions made = at_the_table();
    made.backends = {backend.get()};
    Session session(library_engine(), std::move(made));
    REQUIRE(
        session.compile("let start = home()\n"
                        "try { moveJ(start + [1, 0, 0, 0], time: 9s) } finally {\n"
                        "    for (i in range(300)) { }\n"
                        "    moveJ(start, time: 2s)\n"
                        "    print(\"home\", now())\n"
                        "}\n",
                        "stopped.rbt"));
    REQUIRE(session.run({.until_ns = 500'000'000}) == Progress::kPaused);
    session.cancel();
    Progress progress = Progress::kPaused;
    while (progress == Progress::kPaused) {
      Budget next = slice;
      if (slice.until_ns) next.until_ns = session.host()->now_ns() + *slice.until_ns;
      progress = session.run(next);
    }
    CHECK(progress == Progress::kCancelled);
    return out.str();
  };
  const std::string whole = stopped({});
  CHECK(whole.find("home 2") != std::string::npos);
  for (const Budget& slice : {Budget{.until_ns = 16'666'667}, Budget{.until_ns = {}, .steps = 1},
                              Budget{.until_ns = 1'000'000, .steps = 7}}) {
    const bool is_same = stopped(slice) == whole;
    CHECK(is_same);
  }
}

TEST_CASE("a program that records can be stopped while a robot moves") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile(
      "record run every (30ms) { q: joints()[0] }\n"
      "try { moveJ(home() + [1, 0, 0, 0]) } finally { wait(100ms); print(run.length) }\n",
      "records.rbt"));
  REQUIRE(session.run({.until_ns = 180'000'000}) == Progress::kPaused);
  session.cancel();
  CHECK(session.run().status == Progress::kCancelled);
  CHECK(session.host()->now_ns() < 2'000'000'000);
}

TEST_CASE("a budget of no steps leaves a session as it was") {
  Session session(library_engine(), at_the_table());
  CHECK_THROWS_AS(session.run(Budget{}), ArgumentError);
  REQUIRE(session.compile("wait(1s)\nprint(1)", "wait.rbt"));
  CHECK_THROWS_AS(session.run({.until_ns = {}, .steps = 0}), ArgumentError);
  REQUIRE(session.run({.until_ns = 500'000'000}) == Progress::kPaused);
  CHECK_THROWS_AS(session.run({.until_ns = {}, .steps = 0}), ArgumentError);
  CHECK(session.host()->now_ns() == 500'000'000);
  CHECK(session.run(Budget{}) == Progress::kDone);
  CHECK(session.run().status == Progress::kDone);  // once more, from the start
}

TEST_CASE(
    "a motion under torques sends the same events in slices, and a session may be dropped in it") {
  const auto trace = [](std::int64_t slice_ns) {
    std::ostringstream out;
    const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
    SessionOptions made;
    made.backends = {backend.get()};
    Session session(library_engine(), std::move(made));
    REQUIRE(session.compile(
        "robot arm = robots.puma560()\n"
        "let run = arm.torqueJ(fn(t, q, qd) => arm.gravity(q) - 20.0 * qd, during: 300ms)\n"
        "print(run.drift < 1J, run.events.length)",
        "torques.rbt"));
    Progress progress = Progress::kPaused;
    for (std::int64_t until = slice_ns; progress == Progress::kPaused; until += slice_ns)
      progress = session.run({.until_ns = until});
    REQUIRE(progress == Progress::kDone);
    return out.str();
  };
  CHECK(trace(333'333) == trace(1'000'000'000));
  for (const std::int64_t until : {500'000, 100'000'000}) {
    Session session(library_engine(), {});
    REQUIRE(
        session.compile("robot arm = robots.puma560()\n"
                        "arm.torqueJ(fn(t, q, qd) => zeros(6), during: 1s)",
                        "torques.rbt"));
    CHECK(session.run({.until_ns = until}) == Progress::kPaused);
    CHECK(session.host()->cell().is_moving(0));
  }
}
