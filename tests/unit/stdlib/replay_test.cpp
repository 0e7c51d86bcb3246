// What hosts do to a run, its log, and the run once more.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <thread>

#include "armlet/core/error.hpp"
#include "armlet/core/hash.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "refusal_of.hpp"
#include "tape.hpp"
#include "temporary_folder.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

const char* const kReplayed = R"(
var speed = 10mm/s
var names = ["a"]
fn add(name: string, count: int) -> int {
    for (i in range(count)) { names.push(name) }
    print("added", names)
    return names.length
}
every (100ms) { print(now(), speed, names, signal("gate")) }
wait until signal("gate")
moveJ(home() + [0.2, 0, 0, 0], time: 0.5s)
wait(1s)
)";

constexpr std::int64_t kReplayMs = 1'000'000;

// A session, what it printed and its events.
struct ReplayedRun {
  explicit ReplayedRun(const std::function<void(SessionOptions&)>& change = {}) {
    SessionOptions options = at_the_table();
    options.open = true;
    options.backends = {&tape};
    options.output = [this](std::string_view text) {
      printed += text;
      return std::string();
    };
    if (change) change(options);
    session.emplace(library_engine(), std::move(options));
  }
  Session& operator*() { return *session; }
  Session* operator->() { return &*session; }

  Tape tape;
  std::string printed;
  std::optional<Session> session;
};

// A run to which its host does things at several times.
void run_with_inputs(ReplayedRun& run) {
  run->set_signal("gate", false);
  REQUIRE(run->run({.until_ns = 250 * kReplayMs}) == Progress::kPaused);
  run->set("speed", Value(35.0, "mm/s"));
  REQUIRE(run->run({.until_ns = {}, .steps = 700}) == Progress::kPaused);
  const Result<Value> count = run->call("add", {Value("b"), Value(3)});
  REQUIRE(count.ok());
  CHECK(count->get<std::int64_t>() == 4);
  run->set_signal("gate", true);
  CHECK(run->run().status == Progress::kDone);
}

SessionLog through_file(const SessionLog& log) {
  const Result<std::string> bytes = write_log(log);
  REQUIRE_MESSAGE(bytes.ok(), bytes.error().message);
  Result<SessionLog> read = read_log(*bytes);
  REQUIRE_MESSAGE(read.ok(), read.error().message);
  CHECK(write_log(*read).value() == *bytes);
  return std::move(read).value();
}

}  // namespace

TEST_CASE("a run with inputs of its host is the same again from its log") {
  ReplayedRun first;
  REQUIRE(first->compile(kReplayed, "p.rbt"));
  run_with_inputs(first);
  const SessionLog log = through_file(first->log());
  CHECK(log.entries.back().inputs == first->log().entries.back().inputs);
  CHECK(log.entries.back().inputs.size() == 4);
  ReplayedRun second;
  REQUIRE(second->replay(log));
  CHECK(second->run().status == Progress::kDone);
  CHECK(second.printed == first.printed);
  CHECK(second.tape.hashes() == first.tape.hashes());
  CHECK(second->result().steps == first->result().steps);
  CHECK(write_log(second->log()).value() == write_log(log).value());

  // In slices of any size.
  ReplayedRun third;
  REQUIRE(third->replay(log));
  while (third->run({.until_ns = {}, .steps = 13}) == Progress::kPaused) {
  }
  CHECK(third.tape.hashes() == first.tape.hashes());
}

TEST_CASE("going back shows what was, and going on does what was done") {
  ReplayedRun run;
  REQUIRE(run->compile(kReplayed, "p.rbt"));
  run_with_inputs(run);
  const auto events = run.tape.hashes();
  const std::string printed = run.printed;
  REQUIRE(run->go_to(200 * kReplayMs));
  CHECK(run.printed == printed);  // silently
  CHECK(run->vm()->global("speed").in("mm/s") == 10.0);
  REQUIRE(run->go_to(250 * kReplayMs));
  CHECK(run->vm()->global("speed").in("mm/s") == doctest::Approx(35.0));
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.tape.hashes() == events);
  CHECK(run->runs().empty());
}

TEST_CASE("another input makes another run, and the first one is kept") {
  ReplayedRun run;
  REQUIRE(run->compile(kReplayed, "p.rbt"));
  run_with_inputs(run);
  const auto events = run.tape.hashes();
  const std::string first = write_log(run->log()).value();
  REQUIRE(run->go_to(150 * kReplayMs));
  run->set_signal("gate", true);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.tape.hashes() != events);
  REQUIRE(run->runs().size() == 1);
  CHECK(write_log(run->runs()[0]).value() == first);
  CHECK(run->log().entries.back().inputs.size() == 2);
  // The run that was left can be taken up again.
  const SessionLog left = run->runs()[0];
  REQUIRE(run->replay(left));
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.tape.hashes() == events);
}

TEST_CASE("a run that its host has stopped stops at the same instant again") {
  const char* const text = "var n = 0\ntry { while (true) { n += 1 } } finally { print(n) }\n";
  for (const std::uint64_t steps : {1U, 100U, 4096U, 5000U, 100'003U}) {
    CAPTURE(steps);
    ReplayedRun first;
    REQUIRE(first->compile(text, "p.rbt"));
    CHECK(first->run({.until_ns = {}, .steps = steps}) == Progress::kPaused);
    first->cancel();
    CHECK(first->run().status == Progress::kCancelled);
    ReplayedRun second;
    REQUIRE(second->replay(through_file(first->log())));
    CHECK(second->run().status == Progress::kCancelled);
    CHECK(second.printed == first.printed);
  }
}

TEST_CASE("a run whose host let no more time pass stops there again, and comes to rest") {
  const char* const text = "moveJ(home() + [1, 0, 0, 0])\nwait(1s)\n";
  for (const std::int64_t until : {0, 5, 111, 900}) {
    CAPTURE(until);
    int asked = 0;
    ReplayedRun first([&](SessionOptions& options) {
      options.pace = [&](std::int64_t t_ns) { return t_ns < until * kReplayMs || ++asked > 1; };
    });
    REQUIRE(first->compile(text, "p.rbt"));
    if (until == 111) first->cancel();  // both at once
    CHECK(first->run().status == Progress::kCancelled);
    ReplayedRun second;
    REQUIRE(second->replay(through_file(first->log())));
    CHECK(second->run().status == Progress::kCancelled);
    CHECK(second.tape.hashes() == first.tape.hashes());
  }
}

TEST_CASE("files come from the log, and none is written again") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "given";
  fs::create_directories(folder);
  const char* const program = R"(
figure("f"); plot([1.0, 2.0], [3.0, 4.0])
savePlot("f.svg")
try { savePlot("no/f.svg") } catch (e) { print(e.message) }
wait(1s)
savePlot("g.svg")
)";
  ReplayedRun first([&](SessionOptions& options) { options.folder = folder; });
  REQUIRE(first->compile(program, "p.rbt"));
  CHECK(first->run().status == Progress::kDone);
  CHECK(fs::exists(folder / "f.svg"));
  const SessionLog log = through_file(first->log());
  CHECK(log.entries.back().replies.size() == 3);
  fs::remove_all(folder);

  ReplayedRun second;  // which may write nowhere
  REQUIRE(second->replay(log));
  CHECK(second->run().status == Progress::kDone);
  CHECK(second.printed == first.printed);
  CHECK(second.tape.hashes() == first.tape.hashes());

  fs::create_directories(folder);
  REQUIRE(first->go_to(500 * kReplayMs));
  CHECK(first->run().status == Progress::kDone);
  CHECK(fs::is_empty(folder));
}

TEST_CASE("tables come from the log, those of the check and those of the run") {
  const TemporaryFolder place;
  std::ofstream(place.path() / "known.csv") << "q [deg]\n10\n20\n";
  std::ofstream(place.path() / "late.csv") << "x\n7\n";
  const auto reads = [&](SessionOptions& options) {
    options.folder = place.path();
    options.load = [&](const std::string& path, const std::string&) {
      ImportedText found{.name = path};
      std::ifstream file(place.path() / path);
      if (file) found.text = std::string(std::istreambuf_iterator<char>(file), {});
      return found;
    };
  };
  ReplayedRun first(reads);
  REQUIRE(
      first->compile("print(loadTable(\"known.csv\").q[1])\nwait(1s)\n"
                     "let name = \"late\"\n"
                     "print(loadTable(f\"{name}.csv\", columns: \"x\").x[0])\n",
                     "p.rbt"));
  CHECK(first->run().status == Progress::kDone);
  CHECK(first.printed == "20 deg\n7.0\n");
  const SessionLog log = through_file(first->log());
  std::ofstream(place.path() / "known.csv") << "q [mm]\n1\n2\n";
  std::filesystem::remove(place.path() / "late.csv");

  ReplayedRun second;  // which may read nowhere
  REQUIRE(second->replay(log));
  CHECK(second->run().status == Progress::kDone);
  CHECK(second.printed == first.printed);
  CHECK(second.tape.hashes() == first.tape.hashes());
}

TEST_CASE("output that nobody took is refused at the same print again") {
  int pieces = 0;
  ReplayedRun first([&](SessionOptions& options) {
    options.output = [&](std::string_view) { return ++pieces == 3 ? "full" : std::string(); };
  });
  REQUIRE(first->compile("for (i in range(5)) { print(i); wait(1s) }\n", "p.rbt"));
  CHECK(first->run().status == Progress::kFailed);
  ReplayedRun second;
  REQUIRE(second->replay(through_file(first->log())));
  CHECK(second->run().status == Progress::kFailed);
  CHECK(second->result().error->message == first->result().error->message);
  CHECK(second.tape.hashes() == first.tape.hashes());
}

TEST_CASE("values of all kinds come through a log") {
  SessionLog log;
  log.entries.push_back({.name = "p.rbt", .text = "print(1)\n"});
  const Value::Record record{"Pallet", {{"corner", Value(1.5, "m")}, {"rows", Value(2)}}};
  const Value::Matrix matrix{2, 2, {1.0, -0.0, 1e-300, 3.0}};
  for (const Value& value :
       {Value(), Value(true), Value(-7), Value(0.1), Value(2.0, "kg*m^2"), Value("a\n\"\xff"),
        Value({Value(1), Value("b"), Value(Value::List{})}), Value(matrix), Value(record),
        Value(Value::Enum{"State", "Idle"}), Value(Value::Map{{Value("k"), Value(1.0, "s")}})}) {
    log.entries.back().inputs.push_back({{5, 6}, SetGlobal{"x", value}});
  }
  CHECK(through_file(log).entries.back().inputs == log.entries.back().inputs);
  log.entries.back().inputs.push_back({{}, SetGlobal{"x", Value(Value::Host{})}});
  CHECK(write_log(log).error().message.find("belongs to the host") != std::string::npos);
}

TEST_CASE("a log with its records in another order is refused, with its right sum too") {
  ReplayedRun run;
  REQUIRE(run->compile("print(1)", "p.rbt"));
  const std::string bytes = write_log(run->log()).value();
  const std::size_t begin = bytes.find("robot "), end = bytes.find("default-world ");
  REQUIRE(begin < end);
  const std::size_t sum = bytes.rfind("sum 16\n");
  std::string other = bytes.substr(0, begin) + bytes.substr(end, sum - end);
  other += bytes.substr(begin, end - begin);
  Fnv1a hash;
  hash.add_bytes(other);
  other += fmt::format("sum 16\n{:016x}\n", hash.value());
  CHECK(read_log(other).error().message.find("as this version writes it") != std::string::npos);
}

TEST_CASE("a log that was cut short or changed is refused wherever that is") {
  ReplayedRun run;
  REQUIRE(run->compile(kReplayed, "p.rbt"));
  run_with_inputs(run);
  const std::string bytes = write_log(run->log()).value();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_FALSE(read_log(std::string_view(bytes).substr(0, size)).ok());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    CHECK_FALSE(read_log(changed).ok());
  }
  CHECK(read_log("armlet-log 1 99.0\n").error().message.find("another version") !=
        std::string::npos);
  CHECK(read_log("print(1)").error().message.find("does not begin with") != std::string::npos);
}

TEST_CASE("what cannot be is refused, and the session stays as it was") {
  ReplayedRun run;
  Session& session = *run;
  CHECK(refusal_of([&] { session.set("x", Value(1)); }) ==
        "A session cannot set a variable before its first run.");
  CHECK(refusal_of([&] { static_cast<void>(session.log()); }) ==
        "A session has no sources before its first compile().");
  REQUIRE(session.compile(kReplayed, "p.rbt"));
  CHECK(refusal_of([&] { static_cast<void>(session.go_to(1)); }) ==
        "The run has come to t = 0 s; there is no t = 0.000000001 s to go to.");
  CHECK(session.run({.until_ns = 120 * kReplayMs}) == Progress::kPaused);
  const std::string before = write_log(session.log()).value();
  const auto events = run.tape.hashes();
  for (const std::int64_t t_ns : {std::int64_t{-1}, 121 * kReplayMs})
    CHECK(refusal_of([&] {
            static_cast<void>(session.go_to(t_ns));
          }).starts_with("The run has come"));
  CHECK(refusal_of([&] { session.set("speeed", Value(1)); }).find("did you mean `speed`") !=
        std::string::npos);
  CHECK(refusal_of([&] { session.set("speed", Value(1.0, "s")); }).find("takes a speed") !=
        std::string::npos);
  CHECK(refusal_of([&] { static_cast<void>(session.call("add", {Value(1)})); }) != "");
  const double nan = std::nan("");
  CHECK(refusal_of([&] { session.set("speed", Value(nan, "m/s")); }) ==
        "`speed` takes a speed, and was given nan; any number will do, also an infinite one.");
  CHECK(refusal_of([&] { session.set_signal("force", nan); }) ==
        "The signal \"force\" was given nan; any number will do, also an infinite one.");
  SessionLog other = session.log();
  other.robot = "puma560";
  CHECK(
      refusal_of([&] { session.replay(other); }) ==
      "This log cannot be replayed here: the robot of the log is \"puma560\", that of the session "
      "\"scara\".");
  CHECK(refusal_of([&] { session.run({.until_ns = {}, .steps = 0}); }) != "");
  CHECK(write_log(session.log()).value() == before);
  CHECK(run.tape.hashes() == events);
  session.set_signal("gate", true);
  CHECK(session.run().status == Progress::kDone);
}

TEST_CASE("a session that runs takes nothing from its own output or from another thread") {
  Session* session = nullptr;
  std::vector<std::string> refusals;
  const auto try_all = [&] {
    for (const std::function<void()>& act : std::initializer_list<std::function<void()>>{
             [&] { session->set_signal("gate", true); }, [&] { session->set("n", Value(1)); },
             [&] { static_cast<void>(session->call("f", {})); },
             [&] { static_cast<void>(session->go_to(0)); },
             [&] { static_cast<void>(session->log()); }, [&] { session->replay({}); },
             [&] { static_cast<void>(session->run()); }})
      refusals.push_back(refusal_of(act));
  };
  ReplayedRun run([&](SessionOptions& options) {
    options.output = [&](std::string_view) {
      try_all();
      std::thread(try_all).join();
      return std::string();
    };
  });
  session = &*run;
  REQUIRE(session->compile("var n = 0\nfn f() { n = 2 }\nprint(n)\nassert(n == 0)\n", "p.rbt"));
  CHECK(session->run().status == Progress::kDone);
  CHECK(refusals.size() == 14);
  for (const std::string& each : refusals) CHECK(each != "");
}

TEST_CASE("a cancel while the session goes back gives up the going") {
  ReplayedRun run;
  REQUIRE(run->compile("var n = 0\nfor (i in range(2000000)) { n += 1 }\nwait(1s)\nprint(n)\n",
                       "p.rbt"));
  CHECK(run->run({.until_ns = 500 * kReplayMs}) == Progress::kPaused);
  run->cancel();
  CHECK_FALSE(run->go_to(100 * kReplayMs));
  CHECK(run->host()->now_ns() == 500 * kReplayMs);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.printed == "2000000\n");
}

TEST_CASE("what a paused run looks like") {
  ReplayedRun run;
  REQUIRE(run->compile(kReplayed, "p.rbt"));
  CHECK(run->run({.until_ns = 50 * kReplayMs}) == Progress::kPaused);
  const auto variables = seen_variables(*run->vm());
  REQUIRE(variables.size() == 2);
  CHECK(variables[0].name == "speed");
  CHECK(variables[0].value == "0.01 m/s");
  CHECK(variables[1].type == "string[]");
  const auto tasks = seen_tasks(*run->vm());
  REQUIRE(!tasks.empty());
  CHECK(tasks[0].waits.find("signal") != std::string::npos);
  CHECK(run->sources().position(tasks[0].calls[0].at).line == 10);
}

TEST_CASE("another text continues where its run is the same, and shows where it differs") {
  const std::string text =
      "let h = home()\nprint(1)\nmoveJ(h + [0.1, 0, 0, 0], time: 2s)\nprint(2)\n"
      "moveJ(h, time: 1s)\nwait(2s)\nprint(signal(\"gate\"))\n";
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string changed = text;
    return changed.replace(changed.find(old), old.size(), now);
  };
  ReplayedRun run;
  REQUIRE(run->compile(text, "p.rbt"));
  CHECK(run->run({.until_ns = 2500 * kReplayMs}) == Progress::kPaused);
  const std::string before = write_log(run->log()).value();

  // What does not compile changes nothing.
  CHECK(run->change("print(x)\n", 0).outcome == TextChange::Outcome::kRefused);
  CHECK(!run->problems().empty());
  CHECK(write_log(run->log()).value() == before);

  // A later line is another one: the run is the same so far.
  CHECK(run->change(with("wait(2s)", "wait(3s)"), 2500 * kReplayMs).outcome ==
        TextChange::Outcome::kSame);
  CHECK(run->host()->now_ns() == 2500 * kReplayMs);
  REQUIRE(run->runs().size() == 1);
  CHECK(write_log(run->runs()[0]).value() == before);
  run->set_signal("gate", true);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run->host()->now_ns() == 6000 * kReplayMs);
  CHECK(run.printed == "1\n2\ntrue\n");
  CHECK(run.tape.gaps() == 0);

  // A change of an earlier move makes another run: the answer says where, and the run is made.
  const TextChange parts =
      run->change(with("moveJ(h, time: 1s)", "moveJ(h, time: 1.5s)"), 2500 * kReplayMs);
  CHECK(parts.outcome == TextChange::Outcome::kParts);
  CHECK(parts.same_ns == 2000 * kReplayMs);
  CHECK(parts.parts_ns == 2010 * kReplayMs);
  CHECK(parts.line == 5);
  CHECK(run->host()->now_ns() == 2500 * kReplayMs);
  CHECK(run->run().status == Progress::kDone);

  const TextChange first = run->change("print(3)\n", 1000 * kReplayMs);
  CHECK(first.outcome == TextChange::Outcome::kParts);

  CHECK(run->result().status == Progress::kDone);
}

TEST_CASE("another text that never comes to the time can be stopped, and the run is as it was") {
  ReplayedRun run;
  REQUIRE(run->compile("wait(1s)\nprint(1)\n", "p.rbt"));
  CHECK(run->run({.until_ns = 500 * kReplayMs}) == Progress::kPaused);
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    run->cancel();
  });
  const TextChange change = run->change("var n = 0\nwhile (true) { n = (n + 1) % 7 }\n", 100);
  stopper.join();
  CHECK(change.outcome == TextChange::Outcome::kRefused);
  CHECK(run->host()->now_ns() == 500 * kReplayMs);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.printed == "1\n");
}
