// Intervals of tasks and signals in a recorded run, inputs by buttons, and messages that only pages
// which asked for them receive.

#include <doctest/doctest.h>

#include <string>

#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

struct Shown {
  explicit Shown(const std::string& text) : laboratory(lab_with(text)), page(laboratory) {
    page.hello();
    finish_work(laboratory);
    page.take();
  }
  // Those of a kind and a name.
  TestJson stretches(const std::string& kind, const std::string& name, int run = 1) {
    TestJson out = TestJson::array();
    for (const TestJson& each : page.list("stretches", run))
      if (each["kind"] == kind && each["name"] == name) out.push_back(each);
    return out;
  }
  Laboratory laboratory;
  TestPage page;
};

}  // namespace

TEST_CASE("what each task does is recorded line by line, without gaps, from its begin to its end") {
  Shown lab(R"(robot left = robots.scara()
robot right = robots.scara(base: xyz(1500mm, 0mm, 0mm))
parallel {
    {
        left.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 2s)
        wait(1s)
    }
    right.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 1s)
}
wait(1s)
)");
  REQUIRE(lab.page.last("run")["state"] == "done");
  const TestJson first = lab.stretches("task", "branch 1 of parallel on line 3");
  REQUIRE(first.size() == 2);
  CHECK(first[0]["t0"] == 0.0);
  CHECK(first[0]["t1"] == 2.0);
  CHECK(first[0]["span"][0] == 5);
  CHECK(first[1]["t0"] == 2.0);
  CHECK(first[1]["t1"] == 3.0);
  CHECK(first[1]["span"][0] == 6);
  const TestJson second = lab.stretches("task", "branch 2 of parallel on line 3");
  REQUIRE(second.size() == 1);
  CHECK(second[0]["t1"] == 1.0);
  // The moves are those of their lines.
  for (const TestJson& move : lab.page.list("moves", 1))
    CHECK(move["span"][0] == (move["robot"] == 0 ? 5 : 8));
  // The program waits for them.
  const TestJson own = lab.stretches("task", "");
  REQUIRE(own.size() == 2);
  CHECK(own[0]["t0"] == 0.0);
  CHECK(own[0]["t1"] == 3.0);
  CHECK(own[1]["t1"] == 4.0);
}

TEST_CASE("of tasks with one name and one line each has its own interval") {
  Shown lab(R"(fn both() {
    parallel {
        { wait(1s); wait(2s) }
        wait(500ms)
    }
}
parallel {
    both()
    both()
    both()
}
)");
  REQUIRE(lab.page.last("run")["state"] == "done");
  TestJson times = TestJson::array();
  for (const TestJson& each : lab.stretches("task", "branch 1 of parallel on line 2"))
    times.push_back({each["t0"], each["t1"]});
  const TestJson first = {0.0, 1.0}, second = {1.0, 3.0};
  CHECK(times == TestJson({first, first, first, second, second, second}));
  CHECK(lab.stretches("task", "branch 2 of parallel on line 2").size() == 3);
}

TEST_CASE("a program without other tasks has those of itself alone, and at rest none") {
  Shown lab("robot arm = robots.scara()\narm.moveJ(posJ(10deg, 0deg, 0mm, 0deg), time: 1s)\n");
  REQUIRE(lab.stretches("task", "").size() == 1);
  CHECK(lab.page.list("stretches", 1).size() == 1);
  CHECK(lab.stretches("task", "")[0]["span"][0] == 2);
  CHECK(lab.stretches("task", "")[0]["t1"] == 1.0);
}

TEST_CASE("signals are recorded from change to change, also when a run goes on") {
  Shown lab(R"(robot arm = robots.scara()
lab cell { button on("On", fn() { setSignal("lamp", true); wait(2s) }) }
setSignal("lamp", false)
wait(1s)
setSignal("lamp", true)
wait(500ms)
setSignal("lamp", false)
wait(1s)
)");
  REQUIRE(lab.page.last("run")["state"] == "done");
  const auto times = [&] {
    TestJson out = TestJson::array();
    for (const TestJson& each : lab.stretches("signal", "lamp"))
      out.push_back({each["t0"], each["t1"], each["value"]});
    return out;
  };
  const TestJson once = {{0.0, 1.0, false}, {1.0, 1.5, true}, {1.5, 2.5, false}};
  CHECK(times() == once);
  REQUIRE(lab.page.ask({{"type", "input"}, {"press", "on"}})["type"] == "taken");
  finish_work(lab.laboratory);
  lab.page.take();
  REQUIRE(times().size() == 4);
  CHECK(times()[3] == TestJson({2.5, 4.5, true}));
  CHECK(lab.stretches("task", "cell.on")[0]["t1"] == 4.5);
}

TEST_CASE("what a button could not do names the button") {
  Shown lab(R"(robot arm = robots.scara()
lab cell { button far("Far", fn() { arm.moveL(xyz(9m, 0mm, 0mm), speed: 1m/s) }) }
)");
  REQUIRE(lab.page.ask({{"type", "input"}, {"press", "far"}})["type"] == "taken");
  finish_work(lab.laboratory);
  lab.page.take();
  const TestJson notes = lab.page.list("notes", 1);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0]["element"] == "far");
  CHECK(notes[0]["kind"] == "message");
  CHECK(notes[0]["text"].get<std::string>().find("far: ") == std::string::npos);
}

TEST_CASE("who only looks gets the values of elements with the instant, and moves nobody") {
  Shown lab(R"(robot arm = robots.scara()
lab cell { table q(fn() => [arm.joints()]) }
arm.moveJ(posJ(60deg, 0deg, 0mm, 0deg), time: 2s)
)");
  TestPage other(lab.laboratory);
  other.hello();
  finish_work(lab.laboratory);
  lab.page.ask({{"type", "goto"}, {"t", 2.0}});
  other.take();
  other.told.clear();
  const TestJson seen = lab.page.ask({{"type", "goto"}, {"t", 1.0}, {"looks", true}});
  CHECK(seen["t"] == 1.0);
  CHECK(seen["cursor"] == false);
  CHECK(seen["values"]["q"]["value"][0][0].get<double>() == doctest::Approx(0.5235987756));
  const TestJson row = {"rad", "rad", "m", "rad"};
  CHECK(seen["values"]["q"]["units"] == TestJson::array({row}));
  other.take();
  CHECK(other.last("instant").is_null());
  // Where it steps from is where it was.
  CHECK(lab.page.ask({{"type", "step"}, {"how", "back"}})["t"] != 1.0);
  CHECK(lab.page.ask({{"type", "goto"}, {"t", 1.0}})["values"].is_null());
}

TEST_CASE("an instant shows each point at which a robot presses on something") {
  Shown lab(R"(robot arm = robots.scara(tool: parallelGripper(stroke: 60mm))
object block { shape: box(200mm, 200mm, 40mm); at: xyz(450mm, 0mm, 20mm); fixed: true; stiffness: 1N/mm }
arm.moveJ(xyz(450mm, 0mm, 60mm), time: 2s)
arm.moveL(xyz(450mm, 0mm, 38mm), speed: 10mm/s)
)");
  const double t_end = lab.page.last("run")["t_end"];
  const TestJson before = lab.page.ask({{"type", "goto"}, {"t", 0.0}});
  CHECK(before["presses"].empty());
  const TestJson pressed = lab.page.ask({{"type", "goto"}, {"t", t_end}});
  CAPTURE(lab.page.last("run").dump());
  REQUIRE(!pressed["presses"].empty());
  double up = 0.0;
  for (const TestJson& each : pressed["presses"]) {
    CHECK(each["object"] == "block");
    CHECK(each["robot"] == 0);
    CHECK(each["at"][2].get<double>() < 0.0401);
    up += each["force"][2].get<double>();
  }
  const std::vector<double>& felt = lab.page.rows[{5, 1, 0}];
  REQUIRE(felt.size() >= 7);
  CHECK(up == doctest::Approx(felt[felt.size() - 4]));
}

TEST_CASE("bodies with which collisions are found are described in the frames of shapes") {
  Shown lab("robot arm = robots.puma560()\nwait(1s)\n");
  const TestJson arm = lab.page.last("description")["robots"][0];
  REQUIRE(arm["solids"].size() > 4);
  // The upper arm is drawn and compared as the same capsule.
  int same = 0;
  for (const TestJson& solid : arm["solids"]) {
    for (const TestJson& shape : arm["shapes"]) {
      if (shape["link"] != solid["link"] || shape["kind"] != solid["kind"]) continue;
      double apart = 0.0;
      for (std::size_t k = 0; k < 16; ++k)
        apart =
            std::max(apart, std::abs(shape["T"][k].get<double>() - solid["T"][k].get<double>()));
      same += apart < 1e-12 && shape["radius"] == solid["radius"] ? 1 : 0;
    }
  }
  CHECK(same >= 3);
}
