// Elements of a laboratory's page, and what people do at them.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
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
  CHECK(elements[4]["units"] == TestJson({"rad", "rad", "m", "rad"}));
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

  // The same input at the same position is the same run, bit for bit.
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

TEST_CASE("joints and tool are moved, and what cannot be is refused with the reason") {
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

TEST_CASE("a slider that is pulled leaves one run, not one for each of its positions") {
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

TEST_CASE("what rows show has its units, number by number where they differ") {
  Seated lab(R"(robot arm = robots.scara()
struct Part { name: string; m: mass; far: length }
lab cell {
    table ways(fn() => [arm.joints(), posJ(10deg, 20deg, 10mm, 0deg)])
    table sizes(fn() => [1mm, 2mm])
    table parts(fn() => [Part("a", 1kg, 2mm)])
    table M(fn() => [[1, 2], [3, 4]])
    plot lift(fn() => [3mm, 4mm])
}
wait(1s)
)");
  lab.page.ask({{"type", "goto"}, {"t", 1.0}});
  const TestJson q = {"rad", "rad", "m", "rad"};
  const TestJson values = lab.page.last("elements")["values"];
  CHECK(values["ways"]["units"] == TestJson({q, q}));
  CHECK(values["sizes"]["units"] == "m");
  CHECK(values["parts"]["units"] == TestJson({{{"name", ""}, {"m", "kg"}, {"far", "m"}}}));
  CHECK(values["M"]["units"] == "");
  CHECK(lab.page.last("description")["elements"][4]["units"] == TestJson({"m", "m"}));
}

namespace {

// The units of a plot of each of these functions, of a cell with a SCARA, a Puma and a rail.
TestJson units_of_plots(const std::vector<std::string>& functions) {
  std::string rows;
  for (std::size_t i = 0; i < functions.size(); ++i)
    rows += "    plot p" + std::to_string(i) + "(" + functions[i] + ")\n";
  Seated lab(R"(robot arm = robots.scara()
robot puma = robots.puma560(base: xyz(2m, 0mm, 0mm))
robot rail { joint prismatic(limits: [0mm, 900mm]); joint revolute(a: 300mm, limits: [-90deg, 90deg]) }
fn speeds() { return arm.jointSpeeds() }
fn declared() -> double[] { return arm.jointSpeeds() }
fn of(r: robot) -> double[] { return r.jointSpeeds() }
fn ofAny(r) { let w = r.torques(); return w - r.gravity() }
fn first(r: robot) -> double { return of(r)[0] }
fn both(r: robot, s: robot) -> double[] { return [first(r), first(s)] }
fn turned(v: double[]) -> double[] { return -v }
fn scaled(v: double[], by: double) -> double[] { return v * by }
fn again(r: robot, n: int) -> double[] { return n > 0 ? again(r, n - 1) : r.jointSpeeds() }
lab cell {
)" + rows + "}\narm.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 1s)\n");
  TestJson units = TestJson::array();
  CAPTURE(lab.page.last("run").dump());
  REQUIRE(lab.page.last("diagnostics")["items"].dump() == "[]");
  const TestJson description = lab.page.last("description");
  REQUIRE(description["elements"].size() == functions.size());
  for (const TestJson& each : description["elements"])
    units.push_back(each.value("units", TestJson()));
  return units;
}

}  // namespace

TEST_CASE(
    "numbers of revolute and prismatic joints have their units wherever the text shows them") {
  const TestJson scara = {"rad/s", "rad/s", "m/s", "rad/s"};
  const TestJson known =
      units_of_plots({"fn() => arm.jointSpeeds()",
                      "fn() => puma.torques()",
                      "fn() => rail.jointAccels()",
                      "fn() => speeds()",
                      "speeds",
                      "fn() => arm.jointSpeeds()[2]",
                      "fn() => arm.jointSpeeds()[1:3]",
                      "fn() => -arm.jointSpeeds()",
                      "fn() => norm(arm.tcpSpeed()[0:3])",
                      "fn() => max(puma.torques())",
                      "fn() => [arm.jointSpeeds()[0], arm.jointSpeeds()[2]]",
                      "fn() => puma.torques() - puma.gravity()",
                      "fn() { let w = arm.jointSpeeds(); return w }",
                      "fn() => puma.invDyn(puma.joints(), puma.jointSpeeds(), puma.jointAccels())",
                      "fn() => abs(arm.jointSpeeds()[0])",
                      "fn() => of(arm)",
                      "fn() => of(rail)",
                      "fn() => declared()",
                      "fn() => ofAny(puma)",
                      "fn() => both(arm, rail)",
                      "fn() => both(rail, arm)",
                      "fn() => turned(of(rail))",
                      "fn() => max(of(puma))"});
  const TestJson six = {"Nm", "Nm", "Nm", "Nm", "Nm", "Nm"};
  CHECK(known[0] == scara);
  CHECK(known[1] == six);
  CHECK(known[2] == TestJson({"m/s^2", "rad/s^2"}));
  CHECK(known[3] == scara);
  CHECK(known[4] == scara);
  CHECK(known[5] == TestJson({"m/s"}));
  CHECK(known[6] == TestJson({"rad/s", "m/s"}));
  CHECK(known[7] == scara);
  CHECK(known[8] == TestJson({"m/s"}));
  CHECK(known[9] == TestJson({"Nm"}));
  CHECK(known[10] == TestJson({"rad/s", "m/s"}));
  CHECK(known[11] == six);
  CHECK(known[12] == scara);
  CHECK(known[13] == six);
  CHECK(known[14] == TestJson({"rad/s"}));
  // Through parameters, those that are robots and others, whichever function is written first.
  CHECK(known[15] == scara);
  CHECK(known[16] == TestJson({"m/s", "rad/s"}));
  CHECK(known[17] == scara);
  CHECK(known[18] == six);
  CHECK(known[19] == TestJson({"rad/s", "m/s"}));
  CHECK(known[20] == TestJson({"m/s", "rad/s"}));
  CHECK(known[21] == TestJson({"m/s", "rad/s"}));
  CHECK(known[22] == TestJson({"rad/s"}));
}

TEST_CASE("a table of Denavit and Hartenberg is in angles and lengths") {
  Seated lab(
      "robot arm = robots.scara()\nlab cell { table dh(fn() => arm.dhTable()) }\nwait(1s)\n");
  lab.page.ask({{"type", "goto"}, {"t", 1.0}});
  const TestJson values = lab.page.last("elements")["values"];
  const TestJson row = {"rad", "m", "m", "rad"};
  CHECK(values["dh"]["units"] == TestJson({row, row, row, row}));
  CHECK(values["dh"]["value"].size() == 4);
  CHECK(values["dh"]["value"][0].size() == 4);
}

// A factor may be there to change the unit; a robot may be any.
TEST_CASE("numbers have no unit where the text does not show it, rather than a wrong one") {
  const TestJson none4 = {"", "", "", ""};
  const TestJson unknown = units_of_plots(
      {"fn() => scaled(of(arm), 57.3)", "fn() => arm.jointSpeeds() * 57.3",
       "fn() => arm.jointSpeeds()[0] / 2.0", "fn() => max(arm.jointSpeeds())",
       "fn() => norm(arm.jointSpeeds())",
       "fn() { var w = arm.jointSpeeds(); w[0] = w[0] * 57.3; return w }",
       "fn() => toDegrees(arm.jointSpeeds()[0])", "fn() => arm.jointSpeeds()[0] + 1.0",
       "fn() => of(arm.jointSpeeds()[0] > -100.0 ? arm : rail)", "fn() => again(arm, 2)",
       "fn() => norm(of(rail))"});
  CHECK(unknown[0] == none4);
  CHECK(unknown[1] == none4);
  CHECK(unknown[2] == TestJson({""}));
  CHECK(unknown[3] == TestJson({""}));
  CHECK(unknown[4] == TestJson({""}));
  CHECK(unknown[5] == none4);
  CHECK(unknown[6] == TestJson({""}));
  CHECK(unknown[7] == TestJson({""}));
  CHECK(unknown[8] == none4);
  CHECK(unknown[9] == none4);
  CHECK(unknown[10] == TestJson({""}));
}

TEST_CASE("a robot from a file has the units of the joints that the run finds in it") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "armlet-lab-units";
  fs::create_directories(folder);
  std::ofstream(folder / "arm.urdf") << write_urdf(Mechanism(mechanism_of(*make_robot("scara"))));
  LaboratoryOptions options = lab_with(R"(robot arm = urdf("arm.urdf")
fn of(r: robot) -> double[] { return r.jointSpeeds() }
lab cell {
    plot a(fn() => arm.jointSpeeds())
    plot b(fn() => of(arm)[2])
    plot c(fn() => arm.torques()[1:3])
    plot d(fn() => [arm.tcpSpeed()[0], of(arm)[0]])
    plot e(fn() => -arm.jointSpeeds())
    plot f(fn() => norm(arm.jointSpeeds()))
    plot g(fn() => [of(arm)[3], 1.0])
    plot h(fn() => arm.jointSpeeds()[1:])
}
arm.moveJ(posJ(10deg, 20deg, 10mm, 0deg), time: 1s)
)");
  options.session.folder = folder.string();
  Laboratory laboratory(std::move(options));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  fs::remove_all(folder);
  INFO(page.last("diagnostics").dump());
  REQUIRE(page.last("run")["state"] == "done");
  const TestJson elements = page.last("description")["elements"];
  CHECK(elements[0]["units"] == TestJson({"rad/s", "rad/s", "m/s", "rad/s"}));
  CHECK(elements[1]["units"] == TestJson({"m/s"}));
  CHECK(elements[2]["units"] == TestJson({"Nm", "N"}));
  CHECK(elements[3]["units"] == TestJson({"m/s", "rad/s"}));
  CHECK(elements[4]["units"] == elements[0]["units"]);
  CHECK(elements[5]["units"] == TestJson({""}));
  CHECK(elements[6]["units"] == TestJson({"rad/s", ""}));
  CHECK(elements[7]["units"] == TestJson({"", "", ""}));
}

TEST_CASE("the world has its name where the program asks for it, and none otherwise") {
  Seated own("object cube { shape: box(40mm, 40mm, 40mm); at: xyz(300mm, 120mm, 20mm) }\n");
  CHECK(own.page.last("description")["world"].is_null());
  Seated supplied("insertObj(\"cube\")\nwait(1s)\n");
  CHECK(supplied.page.last("description")["world"] == "table");
  LaboratoryOptions options = lab_with("wait(1s)\n");
  options.session.world = WorldText{
      "bench", "object post { shape: box(40mm, 40mm, 40mm); at: xyz(300mm, 120mm, 20mm) }\n"};
  Laboratory given(std::move(options));
  TestPage page(given);
  page.hello();
  finish_work(given);
  page.take();
  CHECK(page.last("description")["world"] == "bench");
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

namespace {

const std::string kLoads = R"(robot arm = robots.puma560(tool: parallelGripper(stroke: 60mm))
object far { shape: box(40mm, 40mm, 40mm); at: xyz(900mm, 900mm, 20mm) }
lab loads {
    torques bars(of: arm)
    plot tau(fn() => arm.torques())
}
arm.moveJ(posJ(0deg, 45deg, -90deg, 0deg, 45deg, 0deg), time: 4s)
let load = box(40mm, 40mm, 40mm).spawn("load", at: arm.here(), mass: 2kg)
wait(1s)
arm.grasp(load)
wait(1s)
arm.setPayload(1kg)
)";

}  // namespace

TEST_CASE("motor forces are recorded along the run, and jump where a load is taken") {
  Seated lab(kLoads);
  const TestJson description = lab.page.last("description");
  CHECK(description["robots"][0]["joints"][1]["max_force"].get<double>() == doctest::Approx(186.4));
  const std::vector<double>& told = lab.page.rows[{4, 1, 0}];
  const std::vector<double>& plot = lab.page.rows[{3, 1, 1}];
  const std::vector<double>& robot = lab.page.rows[{1, 1, 0}];
  constexpr std::size_t kColumns = 7;
  REQUIRE(told.size() % kColumns == 0);
  REQUIRE(plot.size() % kColumns == 0);
  // The last row at or before a time.
  const auto row_at = [&](double t) {
    std::size_t i = 0;
    while ((i + 1) * kColumns < told.size() && told[(i + 1) * kColumns] <= t) ++i;
    return std::span(told).subspan(i * kColumns, kColumns);
  };
  // While it moves they are what the program reads; rows of motions are sent every 10 ms.
  int compared = 0;
  for (std::size_t i = 0; i < plot.size(); i += kColumns) {
    const std::span<const double> row = row_at(plot[i] + 1e-9);
    if (std::abs(row[0] - plot[i]) > 1e-9 || plot[i] > 3.9) continue;
    ++compared;
    for (std::size_t k = 1; k < kColumns; ++k) CHECK(row[k] == doctest::Approx(plot[i + k]));
  }
  CHECK(compared > 200);
  // The load hangs at the tool point, whose lever about the horizontal axis of joint 2 is its x.
  const double lever = robot[robot.size() - 7];
  CHECK(lever > 0.5);
  CHECK(row_at(5.01)[2] - row_at(4.99)[2] == doctest::Approx(2.0 * 9.81 * lever));
  CHECK(row_at(4.0)[2] == row_at(4.99)[2]);
  // What is set when no time passes any more is reported as well.
  CHECK(told[told.size() - kColumns] == doctest::Approx(6.0));
  CHECK(row_at(6.0)[2] > row_at(5.99)[2] + 1.0);
}

TEST_CASE("rows and objects say where the text makes them") {
  Seated lab("// eins\n" + kLoads);
  const TestJson description = lab.page.last("description");
  CHECK(description["elements"][0]["kind"] == "torques");
  CHECK(description["elements"][0]["robot"] == "arm");
  CHECK(description["elements"][0]["span"] == TestJson({5, 4, 5, 25}));
  CHECK(description["elements"][1]["span"][0] == 6);
  REQUIRE(description["objects"].size() == 2);
  CHECK(description["objects"][0]["span"] == TestJson({3, 7, 3, 10}));
  CHECK(description["objects"][1]["span"][0] == 9);
  // Elements that nobody has written stand nowhere.
  Seated plain("robot arm = robots.scara()\narm.moveJ(posJ(10deg, 0deg, 0mm, 0deg), time: 1s)\n");
  CHECK(plain.page.last("description")["elements"][0]["span"].is_null());
}
