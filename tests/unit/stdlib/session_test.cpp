#include "armlet/stdlib/session.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "armlet/backend/csv_backend.hpp"
#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/backend/recorder.hpp"
#include "armlet/core/error.hpp"
#include "armlet/trajectory/law_planner.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

// The classic program of the language reference, A.1, shortened.
const std::string kClassic = R"(
double[] pick  = {0.61, 0.94, 0.11, -0.33};
double[] over  = {-Math.PI / 4, 1.20, 0.02, 0.45};
double[] place = {-Math.PI / 4, 1.20, 0.11, 0.45};
insertObj("cube");
moveJ('Syn', posJ([0.61, 0.94, 0.02, -0.33]), 2.0);
moveJ('Syn', new posJ(pick), 1.0);
moveJ('Syn', posJ([0.61, 0.94, 0.02, -0.33]), 1.0);
moveJ('Syn', new posJ(over), 2.0);
moveJ('Syn', new posJ(place), 1.0);
moveJ('Syn', new posJ(over), 1.0);
)";

// What a program writes to a backend that `make` makes, when it runs at the table.
std::string trace_of(const std::string& program,
                     std::unique_ptr<Backend> (*make)(std::ostream&) = make_jsonl_backend) {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make(out);
  SessionOptions made = at_the_table();
  made.backends = {backend.get()};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile(program, "classic.rbt"));
  REQUIRE(session.run().status == Progress::kDone);
  return out.str();
}

}  // namespace

TEST_CASE("a classic program really carries the cube from one position to the other") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile(kClassic, "classic.rbt"));
  const RunResult result = session.run();
  REQUIRE(result.status == Progress::kDone);
  const Object& cube = session.host()->cell().world().at("cube");
  // Forward kinematics of the SCARA by hand: 0.4 (cos, sin)(-45 deg) + 0.3 (cos, sin)(1.2 rad - 45
  // deg).
  const Eigen::Vector3d expected(0.557425747501916, -0.161995052690914, 0.24);
  CHECK((cube.T_world_obj.translation() - expected).norm() < 1e-4);
  CHECK(session.host()->cell().world().resting_on("cube") == "table");
  CHECK(session.host()->move_count() == 6);
  CHECK(session.host()->now_ns() == 8'000'000'000);
}

TEST_CASE("the same program gives the same trace, byte for byte") {
  const std::string first = trace_of(kClassic);
  CHECK(first.size() > 10'000);
  CHECK(first == trace_of(kClassic));
}

TEST_CASE("who paces a run is asked at every multiple of 10 ms, and it is the same run") {
  constexpr std::int64_t kStep = 10'000'000;
  // Moves with tasks, conditions and waits that end between these instants.
  const std::string program = R"(
robot arm = robots.scara()
arm.moveJ(posJ(31deg, 12deg, 20mm, 5deg))
when (now() > 1.111s) { print("late") }
parallel {
    { for (i in range(6)) { wait(137ms); print(i) } }
    arm.moveJ(posJ(11deg, 2deg, 20mm, 5deg))
}
wait(333ms)
arm.setJoints(posJ(-10deg, 0deg, 0mm, 0deg))
arm.moveJ(posJ(-20deg, 42deg, 10mm, 0deg), time: 1.2345s)
)";
  Recorder alone, paced;
  std::map<std::int64_t, std::vector<double>> seen;
  for (Recorder* recorder : {&alone, &paced}) {
    SessionOptions options = at_the_table();
    options.backends = {recorder};
    const Session* running = nullptr;
    if (recorder == &paced) {
      options.pace = [&](std::int64_t t_ns) {
        const Cell& cell = running->host()->cell();
        CHECK(t_ns > cell.now_ns());
        CHECK(t_ns <= (cell.now_ns() / kStep + 1) * kStep);
        const Eigen::VectorXd& q = cell.robot(0).q;
        seen[cell.now_ns()].assign(q.begin(), q.end());
        return true;
      };
    }
    Session session(library_engine(), std::move(options));
    running = &session;
    REQUIRE(session.compile(program, "paced.rbt"));
    REQUIRE(session.run().status == Progress::kDone);
  }
  CHECK(paced.same_as(alone));
  CHECK(paced.end_ns() == alone.end_ns());
  for (std::int64_t t_ns = 0; t_ns < paced.end_ns(); t_ns += kStep) CHECK(seen.contains(t_ns));
  int compared = 0;
  for (const RecordedJoints& sample : paced.joints()) {
    const auto at = seen.find(sample.t_ns);
    if (sample.t_ns % kStep != 0 || sample.t_ns == 0 || at == seen.end()) continue;
    CHECK(at->second == sample.q);
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("a failed move leaves everything where it was") {
  Session session(library_engine(), at_the_table());
  REQUIRE(
      session.compile("let before = joints()\n"
                      "try { moveL(xyz(3m, 0m, 0m), time: 1s) } catch (e) { print(e.kind) }\n"
                      "assert(joints() == before)\nassert(now() == 0s)\n",
                      "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
}

TEST_CASE("a world given by the user is used, and its mistakes are reported in its own text") {
  SessionOptions made = at_the_table();
  made.world = WorldText{"lab", "object ball { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }"};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile("assert(poseOf(object(\"ball\")).x == 300mm)", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK_FALSE(session.compile("insertObj(\"cube\")", "p.rbt"));
  REQUIRE_FALSE(session.problems().empty());
  CHECK(session.problems().front().diagnostic.code == "E0203");

  SessionOptions broken = at_the_table();
  broken.world = WorldText{"lab", "object ball { shape: sphere(15); at: xyz(300mm, 0mm, 300mm) }"};
  Session other(library_engine(), std::move(broken));
  CHECK_FALSE(other.compile("print(1)", "p.rbt"));
  REQUIRE_FALSE(other.problems().empty());
  CHECK(other.problems()
            .front()
            .sources->position(other.problems().front().diagnostic.mark.span)
            .line == 1);
}

TEST_CASE("a trace has every robot of the program") {
  const std::string program =
      "robot left = robots.scara(base: xyz(0mm, -1m, 0mm))\n"
      "robot right = robots.planar3(base: xyz(0mm, 1m, 0mm))\n"
      "left.moveJ(posJ(10deg, 0deg, 0mm, 0deg))\n"
      "right.moveJ(posJ(0deg, 0deg, 20deg))\n";
  const std::string trace = trace_of(program);
  CHECK(trace.find("\"left\"") != std::string::npos);
  CHECK(trace.find("\"right\"") != std::string::npos);
  const std::string table = trace_of(program, make_csv_backend);
  CHECK(table.find("robot,left,") != std::string::npos);
  CHECK(table.find("robot,right,") != std::string::npos);
}

TEST_CASE("a program's own objects take the place of those of the default world") {
  Session session(library_engine(), at_the_table());
  REQUIRE(
      session.compile("object cube { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }\n"
                      "insertObj(\"cylinder\")\nassert(poseOf(cube).z == 300mm)\n",
                      "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK(session.host()->cell().world().find("cylinder") != nullptr);
}

TEST_CASE("without any world insertObj makes a stand-in and says so") {
  SessionOptions made = at_the_table();
  made.default_world.reset();
  int advice = 0;
  made.advice = [&](const Diagnostic& d) { advice += d.code == "W0712" ? 1 : 0; };
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile("insertObj(\"thing\")\nassert(getNumberObj() == 1)\n", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK(advice == 1);
}

TEST_CASE("cancelling from another thread stops an endless program") {
  SessionOptions made = at_the_table();
  made.limits.steps = ~std::uint64_t{0};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile("var i = 0\nwhile (true) { i = 1 - i }\n", "p.rbt"));
  std::jthread other([&session] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    session.cancel();
  });
  CHECK(session.run().status == Progress::kCancelled);
}

TEST_CASE("no motion goes beyond the end that the host gives virtual time") {
  SessionOptions made = at_the_table();
  made.limits.time_ns = 3'000'000'000;
  for (const char* text :
       {"moveJ(home(), time: 2s)\nmoveJ(posJ(10deg, 20deg, 30mm, 0deg), time: 2s)",
        "speedJ([0.1, 0.0, 0.0, 0.0], during: 4s)",
        "moveL(here() * xyz(0mm, 0mm, -20mm), time: 4s)"}) {
    Session session(library_engine(), made);
    REQUIRE(session.compile(text, "p.rbt"));
    const RunResult result = session.run();
    REQUIRE(result.error);
    CHECK(result.error->code == "R0636");
  }
}

TEST_CASE("each test runs in a fresh world at time 0") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile(
      "test \"one\" { insertObj(\"cube\"); moveJ(home(), time: 1s); assert(now() == 1s) }\n"
      "test \"two\" { assert(now() == 0s); assert(getNumberObj() == 0) }\n"
      "test \"three\" { assert(1 == 2) }\n",
      "p.rbt"));
  CHECK(session.run_test(0).status == Progress::kDone);
  CHECK(session.run_test(1).status == Progress::kDone);
  const RunResult failed = session.run_test(2);
  REQUIRE(failed.error);
  CHECK(failed.error->code == "R0608");
}

TEST_CASE("a planner of the host can be named by programs") {
  SessionOptions made = at_the_table();
  made.planners = {{"House", planner_of_law(law_of_polynomial(std::vector{0.0, 0.0, 3.0, -2.0}))}};
  Session session(library_engine(), std::move(made));
  REQUIRE(
      session.compile("moveJ(posJ(60deg, 30deg, 0mm, 0deg), time: 2s, traj: \"House\")\n"
                      "assert(planners().last == \"House\")",
                      "house.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK_FALSE(session.compile("moveJ(home(), traj: \"Hose\")", "typo.rbt"));
  CHECK(session.problems().front().diagnostic.fix->text == "did you mean \"House\"?");
}

TEST_CASE("a robot that slows down when the program ends comes to rest in the trace") {
  Recorder recorder;
  SessionOptions made = at_the_table();
  made.backends = {&recorder};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile("speedJ([0.5, 0.0, 0.0, 0.0], during: 300ms)", "rolls.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK_FALSE(session.host()->cell().is_moving(0));
  CHECK(session.host()->cell().robot(0).qd.norm() == 0.0);
  CHECK(session.host()->now_ns() > 300'000'000);
}

TEST_CASE("a session without a program that can run says so") {
  Session session(library_engine(), at_the_table());
  CHECK_THROWS_AS((void)session.run(), ArgumentError);
  CHECK_THROWS_AS((void)session.run_test(0), ArgumentError);
  CHECK_THROWS_AS((void)session.sources(), ArgumentError);
  CHECK_FALSE(session.compile("let = 3", "p.rbt"));
  CHECK_THROWS_AS((void)session.run(), ArgumentError);
  REQUIRE(session.compile(" ", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  REQUIRE(session.compile("print(1)", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK_THROWS_AS((void)session.run_test(0), ArgumentError);
  CHECK(session.run().status == Progress::kDone);
  // The program is well, its world is not.
  SessionOptions broken = at_the_table();
  broken.world = WorldText{"lab", "object ball { shape: sphere(15); at: xyz(300mm, 0mm, 300mm) }"};
  Session other(library_engine(), std::move(broken));
  CHECK_FALSE(other.compile("print(1)", "p.rbt"));
  CHECK_THROWS_AS((void)other.run(), ArgumentError);
}

TEST_CASE(
    "a request to cancel ends with the run that it stops, and one that comes too soon is kept") {
  Session session(library_engine(), at_the_table());
  REQUIRE(session.compile("wait(1s)\nmoveJ(home())", "p.rbt"));
  session.cancel();
  CHECK(session.run().status == Progress::kCancelled);
  CHECK(session.run().status == Progress::kDone);
}

TEST_CASE("a request to cancel stops compiling, and is over with it") {
  Session session(library_engine(), at_the_table());
  session.cancel();
  CHECK_FALSE(session.compile("print(1)", "p.rbt"));
  REQUIRE(session.problems().size() == 1);
  CHECK(session.problems()[0].diagnostic.code == "R0629");
  CHECK_THROWS_AS((void)session.run(), ArgumentError);
  REQUIRE(session.compile("print(1)", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  // Nothing is left of it after a text that is refused before any of it is read.
  session.cancel();
  CHECK_FALSE(session.compile(" ", "p.rbt"));
  CHECK(session.compile("print(1)", "p.rbt"));
}

TEST_CASE("compiling is cancelled from another thread") {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "print(sqrt(" + std::to_string(i) + ".5))\n";
  Session session(library_engine(), at_the_table());
  std::thread other([&session] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    session.cancel();
  });
  CHECK_FALSE(session.compile(text, "p.rbt"));
  other.join();
  REQUIRE(session.problems().size() == 1);
  CHECK(session.problems()[0].diagnostic.code == "R0629");
}

TEST_CASE("what functions of the host throw is a failure, and the session runs again") {
  SessionOptions made = at_the_table();
  int moves = 0;
  made.on_move = [&](const FinishedMove&) {
    if (++moves == 1) throw std::runtime_error("nobody listens");
  };
  std::string printed;
  made.output = [&](std::string_view part) { printed += part; };
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  made.backends = {backend.get()};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile(
      "try { moveJ(home() + [0.1, 0, 0, 0], time: 1s) } catch (e) { print(e.kind) }\n"
      "moveJ(home(), time: 1s)\nprint(now() == 2s)\n",
      "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK(printed == "Host\ntrue\n");
  session.cancel();
  CHECK(session.run().status == Progress::kCancelled);
  CHECK(session.run().status == Progress::kDone);
}

TEST_CASE("a backend that throws fails the program, and leaves nothing that points to it") {
  class Throws : public Backend {
   public:
    void on(const Event& event) override {
      if (std::holds_alternative<JointSample>(event)) throw std::runtime_error("the screen is off");
    }
  };
  Throws backend;
  SessionOptions made = at_the_table();
  made.backends = {&backend};
  Session session(library_engine(), std::move(made));
  REQUIRE(session.compile("moveJ(home() + [0.1, 0, 0, 0], time: 1s)\n", "p.rbt"));
  bool thrown = false;
  try {
    const RunResult result = session.run();
    CHECK(result.status != Progress::kDone);
  } catch (const std::runtime_error&) {
    thrown = true;  // outside the program
  }
  session.cancel();  // there is no machine of that run any more
  (void)thrown;
  CHECK_FALSE(session.compile("print(1)", "p.rbt"));
  CHECK(session.compile("print(1)", "p.rbt"));
}

namespace {

// Throws at events of one kind, and counts what it receives; `ended` is the last.
class ThrowsAt : public Backend {
 public:
  explicit ThrowsAt(EventKinds kinds) : kinds_(kinds) {}
  void on(const Event& event) override {
    ++told;
    ends += kind_of(event) == EventKind::kEndRun ? 1 : 0;
    last = kind_of(event);
    if (kinds_.has(kind_of(event))) throw std::runtime_error("the disk is full");
  }

  int told = 0;
  int ends = 0;
  EventKind last = EventKind::kBeginRun;

 private:
  EventKinds kinds_;
};

}  // namespace

TEST_CASE("a backend that throws at the end leaves the result, and the others receive the end") {
  for (const EventKinds kinds : {EventKinds::of<EndRun>(), EventKinds::of<FinalFigure>(),
                                 EventKinds::of<FinalFigure, EndRun>()}) {
    ThrowsAt before{{}}, throws(kinds), after{{}};
    SessionOptions made = at_the_table();
    made.backends = {&before, &throws, &after};
    Session session(library_engine(), std::move(made));
    REQUIRE(session.compile("plot([0.0, 1.0], [0.0, 1.0])\nprint(\"here\")\n", "p.rbt"));
    for (int run = 1; run <= 2; ++run) {  // it runs again, in a fresh cell
      CHECK_THROWS_WITH(static_cast<void>(session.run()), "the disk is full");
      for (const ThrowsAt* each : {&before, &throws, &after}) {
        CHECK(each->ends == run);
        CHECK(each->last == EventKind::kEndRun);
        CHECK(each->told == before.told);
      }
    }
    CHECK(session.entries().size() == 1);
    const int told = after.told;
    REQUIRE(session.compile("print(1)", "q.rbt"));  // nothing is sent after the end
    CHECK(after.told == told);
  }
}

TEST_CASE("a run that a backend breaks off ends for all others, once") {
  for (const EventKinds kinds :
       {EventKinds::of<BeginRun>(), EventKinds::of<JointSample>(), EventKinds::of<Note>()}) {
    ThrowsAt before{{}}, throws(kinds), after{{}};
    SessionOptions made = at_the_table();
    made.backends = {&before, &throws, &after};
    Session session(library_engine(), std::move(made));
    REQUIRE(session.compile("moveJ(home() + [0.1, 0, 0, 0], time: 1s)\nprint(1)\n", "p.rbt"));
    try {
      static_cast<void>(session.run());
    } catch (const std::runtime_error&) {  // outside the program
    }
    for (const ThrowsAt* each : {&before, &throws, &after}) {
      CHECK(each->ends == 1);
      CHECK(each->last == EventKind::kEndRun);
    }
  }
}

TEST_CASE("a session runs one program at a time") {
  SessionOptions made = at_the_table();
  Session* itself = nullptr;
  std::string said;
  made.on_move = [&](const FinishedMove&) {
    try {
      (void)itself->run();
    } catch (const ArgumentError& error) {
      said = error.what();
    }
    CHECK_THROWS_AS(itself->compile("print(1)", "p.rbt"), ArgumentError);
  };
  Session session(library_engine(), std::move(made));
  itself = &session;
  REQUIRE(session.compile("moveJ(home() + [0.1, 0, 0, 0], time: 1s)", "p.rbt"));
  CHECK(session.run().status == Progress::kDone);
  CHECK(said == "The session runs already; use another one.");
}

TEST_CASE("the library is installed once, and its functions fail where there is no cell") {
  Engine engine;
  install(engine);
  CHECK_THROWS_AS(install(engine), ArgumentError);
  // Nothing that needs a cell, in functions of every chapter, brings the host down.
  for (const char* call :
       {"print(now())", "print(joints())", "moveJ(home())", "insertObj(\"cube\")",
        "print(reachable(here()))", "plot([0, 1], [0, 1])", "savePlot(\"a.svg\")",
        "setNumber(\"a\", 1.0)", "print(robots.scara())", "let r = urdf(\"a.urdf\")", "wait(1s)",
        "setJoints(home())", "speedJ([0.1, 0, 0, 0])"}) {
    const Compilation compiled =
        engine.compile(std::string("try { ") + call + " } catch (e) { print(e.kind) }", "p.rbt");
    if (compiled.program == nullptr) continue;
    CAPTURE(call);
    Vm vm(compiled.program, {});
    const RunResult result = vm.run();
    if (result.status == Progress::kDone) continue;
    REQUIRE(result.error);
    CHECK_FALSE(result.error->message.empty());
  }
}
