// Elements of a laboratory's page, and what people do at them.

#include <doctest/doctest.h>

#include <string>

#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

const std::string kLab = R"(robot arm = robots.scara()
lab cell {
    title: "A cell"
    sliders joints(of: arm)
    sliders hand(of: arm, as: "x y z roll")
    field far(20deg, range: [0deg, 60deg])
    button go("Go", fn() { arm.moveJ(posJ(cell.far, 0deg, 0mm, 0deg), time: 1s) })
    plot angles(fn() => arm.joints())
    table dh(fn() => dhTable(arm))
}
arm.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 1s)
)";

struct Seated {
  explicit Seated(const std::string& text) : laboratory(lab_with(text)), page(laboratory) {
    page.hello();
    finish_work(laboratory);
    page.take();
  }
  double last_joint(int run) {
    const std::vector<double>& rows = page.rows[{1, static_cast<std::uint32_t>(run), 0}];
    return rows[rows.size() - 19];
  }
  Laboratory laboratory;
  TestPage page;
};

}  // namespace

TEST_CASE("the rows of a lab block are described, and what they show is read along the run") {
  Seated lab(kLab);
  const TestJson description = lab.page.last("description");
  REQUIRE(lab.page.last("diagnostics")["runs"] == true);
  CHECK(description["title"] == "A cell");
  CHECK(description["lab"] == "cell");
  const TestJson& elements = description["elements"];
  REQUIRE(elements.size() == 6);
  CHECK(elements[0]["kind"] == "sliders");
  CHECK(elements[1]["axes"].size() == 4);
  CHECK(elements[1]["axes"][0]["lower"] < elements[1]["axes"][0]["upper"]);
  CHECK(elements[2]["kind"] == "field");
  CHECK(elements[2]["unit"] == "deg");
  CHECK(elements[4]["quantity_unit"] == "rad");
  // The plot is what the robot did.
  const std::vector<double>& plot = lab.page.rows[{3, 1, 4}];
  const std::vector<double>& robot = lab.page.rows[{1, 1, 0}];
  REQUIRE(plot.size() >= 100 * 5);
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(plot[5 * i] == doctest::Approx(0.01 * static_cast<double>(i)));
    for (std::size_t j = 1; j < 5; ++j) CHECK(plot[5 * i + j] == robot[20 * i + j]);
  }
  lab.page.ask({{"type", "goto"}, {"t", 1.0}});
  const TestJson values = lab.page.last("elements")["values"];
  CHECK(values["far"]["value"] == doctest::Approx(0.349065850398866));
  CHECK(values["hand"]["value"].size() == 4);
  CHECK(values["dh"]["value"].size() == 4);
}

TEST_CASE("inputs at the end go on with the run; those before make another one") {
  Seated lab(kLab);
  CHECK(lab.page.ask({{"type", "input"}, {"set", "far"}, {"value", 0.5}})["type"] == "taken");
  CHECK(lab.page.ask({{"type", "input"}, {"press", "go"}})["run"] == 1);
  CHECK(lab.page.last("run")["t_end"] == 2.0);
  CHECK(lab.last_joint(1) == doctest::Approx(0.5));
  CHECK(lab.page.ask({{"type", "goto"}, {"t", 2.0}})["t"] == 2.0);
  CHECK(lab.page.last("elements")["values"]["far"]["value"] == 0.5);
  const std::string hash = lab.page.last("run")["hash"];

  // The same input at the same place is the same run, bit for bit.
  const TestJson again = lab.page.ask({{"type", "input"}, {"press", "go"}, {"t", 1.0}});
  CHECK(again["type"] == "taken");
  CHECK(again["run"] == 2);
  CHECK(lab.page.last("run")["parent"] == 1);
  CHECK(lab.page.last("run")["hash"] == hash);
  CHECK(lab.page.ask({{"type", "compare"}, {"run", 1}, {"with", 2}})["same"] == true);

  // What came later is no part of a run that is left before it.
  CHECK(lab.page.ask({{"type", "input"}, {"set", "far"}, {"value", 0.2}, {"t", 0.5}})["run"] == 3);
  CHECK(lab.page.last("run")["t_end"] == 1.0);
  CHECK(lab.page.last("run")["inputs"].size() == 1);
  lab.page.ask({{"type", "goto"}, {"t", 0.4}});
  CHECK(lab.page.last("elements")["values"]["far"]["value"] == doctest::Approx(0.349065850398866));
  lab.page.ask({{"type", "goto"}, {"t", 0.5}});
  CHECK(lab.page.last("elements")["values"]["far"]["value"] == 0.2);
}

TEST_CASE("joints and hand are moved, and what cannot be is refused with the reason") {
  Seated lab(kLab);
  CHECK(lab.page.ask(
            {{"type", "input"}, {"joints", "arm"}, {"values", {0.1, 0.2, 0.03, 0.4}}})["type"] ==
        "taken");
  CHECK(lab.last_joint(1) == 0.1);
  lab.page.ask({{"type", "goto"}, {"t", 1.0}});
  TestJson hand = lab.page.last("elements")["values"]["hand"]["value"];
  hand[0] = hand[0].get<double>() - 0.02;
  CHECK(lab.page.ask({{"type", "input"}, {"hand", "hand"}, {"values", hand}})["type"] == "taken");
  hand[0] = 9.0;
  const TestJson refused = lab.page.ask({{"type", "input"}, {"hand", "hand"}, {"values", hand}});
  CHECK(refused["type"] == "error");
  CHECK(refused["message"].get<std::string>().find("reach") != std::string::npos);
  for (const TestJson& input :
       {TestJson{{"type", "input"}, {"joints", "arm"}, {"values", {9.0, 0, 0, 0}}},
        TestJson{{"type", "input"}, {"joints", "arm"}, {"values", {0.0}}},
        TestJson{{"type", "input"}, {"joints", "nobody"}, {"values", {0.0}}},
        TestJson{{"type", "input"}, {"set", "far"}, {"value", 2.0}},
        TestJson{{"type", "input"}, {"set", "far"}, {"value", "x"}},
        TestJson{{"type", "input"}, {"set", "near"}, {"value", 2.0}},
        TestJson{{"type", "input"}, {"press", "stop"}},
        TestJson{{"type", "input"}, {"press", "stop"}, {"t", 0.5}},
        TestJson{{"type", "input"}, {"joints", "arm"}, {"values", {0, 0, 0, 0}}, {"t", 0.5}}}) {
    CAPTURE(input.dump());
    CHECK(lab.page.ask(input)["type"] == "error");
  }
  CHECK(lab.page.last("shown")["run"] == 1);
  CHECK(lab.page.last("run")["state"] == "done");
}

TEST_CASE("a slider that is pulled leaves one run, not one for each of its places") {
  Seated lab(kLab);
  lab.page.ask({{"type", "input"}, {"press", "go"}});
  for (int i = 0; i < 5; ++i)
    lab.page.ask({{"type", "input"}, {"set", "far"}, {"value", 0.1 * i}, {"t", 1.0}});
  CHECK(lab.page.last("runs")["list"].size() == 2);
}

TEST_CASE("a program in which nothing moves shows its robots and objects") {
  Seated lab(
      "robot arm = robots.scara()\nobject cube { shape: box(40mm, 40mm, 40mm); at: xyz(300mm, "
      "120mm, 20mm) }\n");
  const TestJson description = lab.page.last("description");
  REQUIRE(description["robots"].size() == 1);
  CHECK(description["objects"][0]["name"] == "cube");
  CHECK(description["elements"].size() >= 2);
}

TEST_CASE("a program without a block has sliders all the same") {
  Seated lab("robot arm = robots.scara()\narm.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 1s)\n");
  const TestJson description = lab.page.last("description");
  CHECK(description["lab"].is_null());
  CHECK(description["elements"].size() >= 2);
  CHECK(lab.page.ask(
            {{"type", "input"}, {"joints", "arm"}, {"values", {0.1, 0.2, 0.03, 0.4}}})["type"] ==
        "taken");
  CHECK(lab.last_joint(1) == 0.1);
}

TEST_CASE("a plot shows what a button did, also where the program itself took no time") {
  Seated lab(
      "robot arm = robots.scara()\nlab cell {\n"
      "    button go(\"Go\", fn() { arm.moveJ(posJ(30deg, 0deg, 0mm, 0deg), time: 1s) })\n"
      "    plot angles(fn() => arm.joints())\n}\n");
  REQUIRE(lab.page.ask({{"type", "input"}, {"t", 0}, {"press", "go"}})["type"] == "taken");
  finish_work(lab.laboratory);
  lab.page.take();
  const std::vector<double>& plot = lab.page.rows[{3, 1, 1}];
  REQUIRE(plot.size() >= 100 * 5);
  CHECK(plot[1] == 0.0);
  CHECK(plot[plot.size() - 5] == 1.0);
  CHECK(plot[plot.size() - 4] == doctest::Approx(lab.last_joint(1)));
}
