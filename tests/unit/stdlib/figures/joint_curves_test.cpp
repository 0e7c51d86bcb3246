// Curves of numbers for joints, whose type has no unit: their units, and that angles and
// lengths never share an axis.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "armlet/backend/backend.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "temporary_folder.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

class KeptFigures : public Backend {
 public:
  void on(const Event& event) override {
    if (const auto* last = std::get_if<FinalFigure>(&event)) figures.push_back(*last->figure);
  }
  std::vector<Figure> figures;
};

const char* const kScaraRecord =
    "robot arm = robots.scara()\n"
    "record run every (100ms) {\n"
    "    qd: arm.jointSpeeds(); tau: arm.torques(); v: arm.tcpSpeed(); q: arm.joints();\n"
    "    slide: arm.jointSpeeds()[2]; plain: [1.0, 2.0]\n"
    "}\n"
    "arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\n";

RunResult run_with_curves(const std::string& program, std::vector<Figure>& figures,
                          const fs::path& folder = {}) {
  KeptFigures kept;
  SessionOptions options;
  options.backends = {&kept};
  options.folder = folder;
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(program, "curves.rbt"));
  RunResult result = session.run();
  figures = std::move(kept.figures);
  return result;
}

std::vector<Figure> curves_of(const std::string& program) {
  std::vector<Figure> figures;
  const RunResult result = run_with_curves(program, figures);
  if (result.error) MESSAGE(result.error->message);
  REQUIRE(result.status == Progress::kDone);
  return figures;
}

// "rad/s rad/s | m/s": the axis and the series on the left, and on the right.
std::string sides_of(const Figure& figure) {
  std::string left = figure.y.unit + ":", right = figure.right.unit + ":";
  for (std::size_t i = 0; i < figure.series.size(); ++i)
    (figure.series[i].right ? right : left) += std::to_string(i + 1);
  return left + " | " + right;
}

}  // namespace

TEST_CASE("a record is drawn with the units of its joints, on two axes where some slide") {
  const auto figures = curves_of(std::string(kScaraRecord) + "plot(run)\n");
  REQUIRE(figures.size() == 1);
  const std::vector<Figure>& panels = figures[0].panels;
  REQUIRE(panels.size() == 6);
  CHECK(sides_of(panels[0]) == "rad/s:124 | m/s:3");
  CHECK(sides_of(panels[1]) == "Nm:124 | N:3");
  CHECK(sides_of(panels[2]) == "m/s:123 | rad/s:456");
  CHECK(sides_of(panels[3]) == "rad:124 | m:3");
  CHECK(sides_of(panels[4]) == "m/s:1 | :");
  CHECK(sides_of(panels[5]) == ":12 | :");
  const std::string text = to_braille(figures[0]);
  for (const char* unit : {"deg/s", "Nm", "mm/s"}) {
    CAPTURE(unit);
    CHECK(text.find(unit) != std::string::npos);
  }
}

TEST_CASE("columns, slices and elements of numbers for joints keep their units") {
  const std::pair<const char*, const char*> kinds[] = {
      {"plot(run.t, run.qd)", "rad/s:124 | m/s:3"},
      {"plot(run.t, run.qd[:, 0])", "rad/s:1 | :"},
      {"plot(run.t, run.qd[:, 2])", "m/s:1 | :"},
      {"plot(run.t, run.qd[:, 1:3])", "rad/s:1 | m/s:2"},
      {"plot(run.t, run.slide)", "m/s:1 | :"},
      {"plot(run.t, [run.tau[:, 0], run.tau[:, 2]])", "Nm:1 | N:2"},
      {"plot(run.t, run.qd[:, 0] - run.qd[:, 1])", "rad/s:1 | :"},
      {"plot(run.t, run.qd[:, 0] * 57.3)", ":1 | :"},
      {"plot(run.t, run.plain)", ":12 | :"},
      {"plot(run.t, run.q.map(fn(q) => 1000 * q[2]))", ":1 | :"},
      {"plot(run.t, run.q.map(fn(q) => q[2]))", "m:1 | :"},
      {"plot(run.t, run.q.map(fn(q) => q.q[1]))", "rad:1 | :"},
      {"plot(run.t, run.q.map(fn(q) => (q - arm.home())[2]))", "m:1 | :"},
      {"plot(run.t, matrix(run.q.map(fn(q) => [q[0], q[2]])))", "rad:1 | m:2"},
      {"struct Both { qd: double[] }\n"
       "let both = Both(arm.jointSpeeds())\n"
       "bars([\"a\", \"b\", \"c\", \"d\"], both.qd)",
       "rad/s:1 | m/s:2"},
      {"plot(run.qd[:, 2])", "m/s:1 | :"},
      {"plot(run.t, run.qd[:, 0]); plot(run.t, run.qd[:, 2])", "rad/s:1 | m/s:2"},
      {"plot(run.t, run.qd[:, 2]); plot(run.t, run.qd[:, 0]); plot(run.t, run.qd[:, 1])",
       "m/s:1 | rad/s:23"},
      // Beside numbers of which nothing is known they are plain numbers, and still not beside
      // others.
      {"plot(run.t, run.qd[:, 0]); plot(run.t, run.plain[:, 0])", ":12 | :"},
      {"plot(run.t, run.plain[:, 0]); plot(run.t, run.qd[:, 0]); plot(run.t, run.qd[:, 2])",
       ":12 | m/s:3"},
      {"let tr = trajectory(\"434\", [arm.home(), posJ(60deg, 30deg, 50mm, 0deg)], time: 2s)\n"
       "let t = [0s, 1s, 2s]\n"
       "plot(t, t.map(fn(x) => tr.qd(x)[0])); plot(t, t.map(fn(x) => tr.qdd(x)[1]), axis: "
       "\"right\")",
       "rad/s:1 | rad/s^2:2"},
      {"bars([\"a\", \"b\", \"c\", \"d\"], arm.torques())", "Nm:1 | N:2"},
      {"plot(run.t, run.qd, yUnit: \"steps\")", "steps:1234 | :"},
  };
  for (const auto& [call, sides] : kinds) {
    const std::string statement(call);
    CAPTURE(statement);
    const auto figures = curves_of(std::string(kScaraRecord) + call + "\n");
    REQUIRE(figures.size() == 1);
    CHECK(sides_of(figures[0]) == sides);
  }
}

TEST_CASE("what cannot have an axis of its own is refused, and the figure stays") {
  for (const char* call :
       {"plot(run.t, run.qd, axis: \"left\")", "plot(run.t, run.qd, axis: \"right\")",
        "plot(run.t, run.qd); plot(run.t, run.tau)"}) {
    CAPTURE(call);
    std::vector<Figure> figures;
    const RunResult result = run_with_curves(std::string(kScaraRecord) + call + "\n", figures);
    REQUIRE(result.error);
    CHECK(result.error->code == "R0626");
    CHECK(result.error->message.find("on that axis") != std::string::npos);
  }
}

TEST_CASE("over all arms of the catalogue, curves of speeds share an axis only with their like") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto figures = curves_of("robot arm = robots." + std::string(name) +
                                   "()\nrecord run every (1s) { qd: arm.jointSpeeds() }\nwait(1s)\n"
                                   "plot(run.t, run.qd)\nfigure(\"all\"); plot(run)\n");
    REQUIRE(figures.size() == 2);
    const auto robot = make_robot(name);
    for (const Figure* figure : {&figures[0], &figures[1].panels[0]}) {
      REQUIRE(static_cast<int>(figure->series.size()) == robot->n());
      for (int joint = 0; joint < robot->n(); ++joint) {
        const bool right = figure->series[static_cast<std::size_t>(joint)].right;
        CHECK((right ? figure->right.unit : figure->y.unit) ==
              (robot->is_revolute(joint) ? "rad/s" : "m/s"));
      }
    }
  }
}

TEST_CASE("a table is saved with the units of its joints in the heading") {
  const TemporaryFolder place;
  const fs::path& folder = place.path();
  std::vector<Figure> figures;
  REQUIRE(run_with_curves(std::string(kScaraRecord) + "run.save(\"run.csv\")\n", figures, folder)
              .status == Progress::kDone);
  std::ifstream in(folder / "run.csv");
  std::string heading;
  std::getline(in, heading);
  CHECK(
      heading ==
      "t [s],qd1 [rad/s],qd2 [rad/s],qd3 [m/s],qd4 [rad/s],tau1 [Nm],tau2 [Nm],tau3 [N],tau4 [Nm],"
      "v1 [m/s],v2 [m/s],v3 [m/s],v4 [rad/s],v5 [rad/s],v6 [rad/s],q1 [rad],q2 [rad],q3 [m],q4 "
      "[rad],"
      "slide [m/s],plain1,plain2");
}
