// What a host looks at and calls between two slices is no part of the run: the run, its steps, its
// log and where it stands are as if nobody had looked.
#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/interpreter/host/program_function.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "tape.hpp"

using namespace armlet;

namespace {

const char* const kLookedAt = R"(var n = 0
var total = 0.0
fn turns(k: int) -> int { var i = 0
    while (i < k) { i += 1 }
    return i }
fn inverse() -> double { return inv(matrix([[2.0, 1.0], [1.0, 3.0]]))[0, 0] }
fn broken() -> int { let xs = [1]
    return xs[n + 3] }
every (30ms) { n += 1 }
moveJ(home() + [0.2, 0, 0, 0], time: 0.5s)
for (i in range(300)) {
    total += i
    if (i % 50 == 0) { wait(10ms) }
}
wait until signal("gate"), timeout: 3s
print(n, total, now())
)";

struct LookedAt {
  explicit LookedAt(bool markers = false) {
    SessionOptions options = at_the_table();
    options.open = true;
    options.markers = markers;
    options.backends = {&tape};
    options.output = [this](std::string_view text) {
      printed += text;
      return std::string();
    };
    session.emplace(library_engine(), std::move(options));
  }
  Session* operator->() { return &*session; }
  Vm& vm() { return *session->vm(); }

  Tape tape;
  std::string printed;
  std::optional<Session> session;
};

// Everything that a host can ask of the machine without its session hearing of it.
void look(Vm& vm) {
  CHECK(*vm.function<std::int64_t(std::int64_t)>("turns")(5000) == 5000);
  CHECK(*vm.function<double()>("inverse")() == doctest::Approx(0.6));
  CHECK_FALSE(vm.function<std::int64_t()>("broken")());
  vm.cancel();
  CHECK_FALSE(vm.function<std::int64_t(std::int64_t)>("turns")(1'000'000));
  CHECK(vm.error()->code == "R0629");
}

struct Outcome {
  std::string printed;
  std::string log;
  std::vector<std::uint64_t> events;
  std::uint64_t steps = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(LookedAt& run) {
  return {run.printed, write_log(run->log()).value(), run.tape.hashes(), run->result().steps};
}

// In slices of so many steps, with a signal between two of them.
Outcome run_in_slices(LookedAt& run, std::uint64_t steps, bool looks) {
  int slice = 0;
  while (run->run({.until_ns = {}, .steps = steps}) == Progress::kPaused) {
    if (++slice == 20) run->set_signal("gate", true);
    if (looks && run.vm().try_global("total")) look(run.vm());
  }
  CHECK(run->result().status == Progress::kDone);
  return outcome_of(run);
}

}  // namespace

TEST_CASE("a host that calls functions between slices changes neither the run nor its log") {
  for (const std::uint64_t steps : {1U, 7U, 40U}) {
    CAPTURE(steps);
    LookedAt plain;
    REQUIRE(plain->compile(kLookedAt, "p.rbt"));
    const Outcome expected = run_in_slices(plain, steps, false);
    LookedAt looked;
    REQUIRE(looked->compile(kLookedAt, "p.rbt"));
    CHECK(run_in_slices(looked, steps, true) == expected);
    LookedAt again;
    REQUIRE(again->replay(read_log(expected.log).value()));
    while (again->run({.until_ns = {}, .steps = 11}) == Progress::kPaused)
      if (again.vm().try_global("total")) look(again.vm());
    CHECK(outcome_of(again) == expected);
  }
}

TEST_CASE("calls that the session keeps count with the run, and again in another one") {
  LookedAt first;
  REQUIRE(first->compile(kLookedAt, "p.rbt"));
  REQUIRE(first->run({.until_ns = 100'000'000}) == Progress::kPaused);
  const std::uint64_t before = first->result().steps;
  look(first.vm());
  REQUIRE(first->call("turns", {Value(700)}).ok());
  look(first.vm());
  first->set("n", Value(40));
  REQUIRE(first->run({.until_ns = {}, .steps = 1}) == Progress::kPaused);
  CHECK(first->result().steps - before > 700);
  CHECK(first->result().steps - before < 800);
  first->cancel();
  CHECK(first->run().status == Progress::kCancelled);
  LookedAt second;
  REQUIRE(second->replay(first->log()));
  CHECK(second->run().status == Progress::kCancelled);
  CHECK(outcome_of(second) == outcome_of(first));
}

TEST_CASE("a call at a breakpoint leaves the run there, and what is seen") {
  LookedAt run(true);
  REQUIRE(run->compile(kLookedAt, "p.rbt"));
  CHECK(run->set_breakpoints({{.line = 12}}).size() == 1);
  REQUIRE(run->run().status == Progress::kPaused);
  const auto here = [&] {
    std::string seen;
    for (const SeenTask& task : seen_tasks(run.vm()))
      for (const SeenCall& call : task.calls) {
        seen += std::to_string(run->sources().position(call.at).line) + ' ';
        for (const SeenVariable& each : call.variables) seen += each.name + '=' + each.value + ' ';
      }
    return seen;
  };
  const std::string seen = here();
  CHECK(seen.find("12 i=0") != std::string::npos);
  const std::uint64_t begun = statements_begun(run.vm());
  for (int i = 0; i < 2; ++i) {
    look(run.vm());
    CHECK(
        value_at(run.vm(), 0, static_cast<std::uint32_t>(std::string(kLookedAt).find("i\n    if")))
            ->value == "0");
    CHECK(is_at_breakpoint(run.vm()));
    CHECK(statements_begun(run.vm()) == begun);
    CHECK(here() == seen);
  }
  REQUIRE(run->run().status == Progress::kPaused);  // the next pass, not the same one again
  CHECK(here().find("12 i=1") != std::string::npos);
  look(run.vm());
  REQUIRE(run->step_back());
  CHECK(statements_begun(run.vm()) > begun);
  CHECK(here().find("i=0") != std::string::npos);
}

TEST_CASE("a run that is being stopped stays so, whatever its host calls meanwhile") {
  const char* const text =
      "var n = 0\nfn broken() -> int { let xs = [1]\n return xs[n + 3] }\n"
      "try { while (true) { } } finally { while (true) { n += 1 } }\n";
  std::vector<std::int64_t> counted;
  for (const bool calls : {false, true}) {
    LookedAt run;
    REQUIRE(run->compile(text, "p.rbt"));
    REQUIRE(run->run({.until_ns = {}, .steps = 100}) == Progress::kPaused);
    run->cancel();
    while (run->run({.until_ns = {}, .steps = 5000}) == Progress::kPaused)
      if (calls) CHECK_FALSE(run.vm().function<std::int64_t()>("broken")());
    CHECK(run->result().error->code == "R0629");  // finally blocks may not take for ever
    counted.push_back(run.vm().global<std::int64_t>("n"));
  }
  CHECK(counted[0] == counted[1]);
  CHECK(counted[0] == 1'000'001);
}

TEST_CASE("a stop that is taken again is noticed at the same step, also if values are looked at") {
  const std::string text = "var n = 0\ntry { while (true) { n += 1 } } finally { print(n) }\n";
  LookedAt first;
  REQUIRE(first->compile(text, "p.rbt"));
  REQUIRE(first->run({.until_ns = {}, .steps = 30'123}) == Progress::kPaused);
  first->cancel();
  CHECK(first->run().status == Progress::kCancelled);
  LookedAt second(true);
  SessionLog log = first->log();
  REQUIRE(second->replay(log));
  const auto at = static_cast<std::uint32_t>(text.find("1 } }"));
  while (second->run({.until_ns = {}, .steps = 2500}) == Progress::kPaused)
    CHECK(value_at(second.vm(), 0, at).ok());
  CHECK(second->result().status == Progress::kCancelled);
  CHECK(second.printed == first.printed);
  CHECK(second->result().steps == first->result().steps);
}

TEST_CASE("a program that is compiled once is shared by sessions, each with a run of its own") {
  SessionOptions options = at_the_table();
  options.open = true;
  Session maker(library_engine(), options);
  CHECK_THROWS_WITH_AS(Session(library_engine(), options).share(maker),
                       "There is no program to share: compile() one in the other session first.",
                       ArgumentError);
  REQUIRE(maker.compile(kLookedAt, "p.rbt"));
  std::vector<std::unique_ptr<Session>> sessions;
  for (int i = 0; i < 20; ++i) {
    sessions.push_back(std::make_unique<Session>(library_engine(), options));
    sessions.back()->share(i == 0 ? maker : *sessions[static_cast<std::size_t>(i) - 1]);
    CHECK(sessions.back()->program() == maker.program());
    REQUIRE(sessions.back()->run({.until_ns = 20'000'000}) == Progress::kPaused);
    sessions.back()->set("n", Value(100 * i));
    sessions.back()->set_signal("gate", true);
  }
  maker.set_signal("gate", true);
  CHECK(maker.run().status == Progress::kDone);
  const auto beats = maker.vm()->global<std::int64_t>("n");
  for (int i = 0; i < 20; ++i) {
    Session& session = *sessions[static_cast<std::size_t>(i)];
    CHECK(session.run().status == Progress::kDone);
    CHECK(session.vm()->global<std::int64_t>("n") == 100 * i + beats - 1);  // one was before set()
  }
  // Whoever shares can do with it whatever else a session does.
  Session& one = *sessions[3];
  REQUIRE(one.go_to(10'000'000));
  CHECK(one.run().status == Progress::kDone);
  CHECK(one.change("print(1)\n", 0).outcome == TextChange::Outcome::kParts);

  SessionOptions other = options;
  other.markers = true;
  Session refused(library_engine(), other);
  REQUIRE(refused.compile("print(2)\n", "q.rbt"));
  CHECK_THROWS_AS(refused.share(maker), ArgumentError);
  CHECK(refused.run().status == Progress::kDone);  // as it was
}
