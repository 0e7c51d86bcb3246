// Figures of programs: their units, their files, and what backends receive.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "armlet/backend/backend.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

bool is_same(const Axis& one, const Axis& other) {
  return std::tie(one.label, one.unit, one.log) == std::tie(other.label, other.unit, other.log);
}

bool is_same(const Series& one, const Series& other) {
  return std::tie(one.kind, one.label, one.x, one.y, one.z, one.right) ==
         std::tie(other.kind, other.label, other.x, other.y, other.z, other.right);
}

bool is_same(const Figure& one, const Figure& other) {
  const auto each = [](const auto& a, const auto& b) { return is_same(a, b); };
  return one.title == other.title && one.names == other.names && is_same(one.x, other.x) &&
         is_same(one.y, other.y) && is_same(one.z, other.z) && is_same(one.right, other.right) &&
         std::ranges::equal(one.series, other.series, each) &&
         std::ranges::equal(one.panels, other.panels, each);
}

// What a listener received of a figure: its index, its title and how many series it has.
using Told = std::tuple<int, std::string, std::size_t>;

class Figures : public Backend {
 public:
  void on(const Event& event) override {
    std::visit(
        Overload{[this](const BeginRun&) { began = true; },
                 [this](const FigureChanged& each) {
                   CHECK(began);
                   CHECK(figures.empty());
                   changed[each.index] = *each.figure;
                   told.emplace_back(each.index, each.figure->title, each.figure->series.size());
                 },
                 [this](const FinalFigure& each) {
                   CHECK(began);
                   const bool is_told = changed.count(each.index) != 0;
                   CHECK(is_same(is_told ? changed[each.index] : Figure{}, *each.figure));
                   figures.push_back(*each.figure);
                 },
                 [this](const EndRun&) { ended_after = figures.size(); }, [](const auto&) {}},
        event);
  }

  bool began = false;
  std::size_t ended_after = 0;
  std::vector<Figure> figures;
  std::map<int, Figure> changed;  // the last state of each
  std::vector<Told> told;
};

Figures heard_of(const std::string& program, const fs::path& folder = {}) {
  Figures backend;
  SessionOptions options;
  options.backends = {&backend};
  options.folder = folder;
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(program, "figures.rbt"));
  const RunResult result = session.run();
  if (result.error) MESSAGE(result.error->message);
  REQUIRE(result.status == Progress::kDone);
  CHECK(backend.ended_after == backend.figures.size());
  return backend;
}

std::vector<Figure> figures_of(const std::string& program, const fs::path& folder = {}) {
  return heard_of(program, folder).figures;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("axes have the units of the types that are plotted") {
  const auto figures = figures_of(
      "let t = [0s, 1s]\n"
      "figure(\"a\"); plot(t, [0deg, 90deg])\n"
      "figure(\"b\"); plot(t, [1mm, 2mm] / 1s, label: \"tool\")\n"
      "figure(\"c\"); bars([1.0, 2.0], [3N, 4N] * 1m)\n"
      "figure(\"d\"); plot([1, 2], [0.5, 0.25])\n"
      "figure(\"e\"); plot(t, [1m, 2m], yUnit: \"steps\")\n");
  REQUIRE(figures.size() == 5);
  CHECK(figures[0].x.unit == "s");
  CHECK(figures[0].y.unit == "rad");
  CHECK(figures[0].x.label == "time");
  CHECK(figures[0].series[0].y[1] == doctest::Approx(1.5707963));
  CHECK(figures[1].y.unit == "m/s");
  CHECK(figures[1].series[0].label == "tool");
  CHECK(figures[2].y.unit == "Nm");
  CHECK(figures[2].series[0].kind == SeriesKind::kBars);
  CHECK(figures[3].x.unit.empty());
  CHECK(figures[4].y.unit == "steps");
}

TEST_CASE("the axis on the right has a unit of its own") {
  const auto figures = figures_of(
      "plot([0s, 1s], [0deg, 90deg], label: \"angle\")\n"
      "plot([0s, 1s], [1m, 2m], axis: \"right\", label: \"height\")\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].y.unit == "rad");
  CHECK(figures[0].right.unit == "m");
  CHECK(figures[0].series[1].right);
}

TEST_CASE("a title that is there goes on with its figure") {
  const auto figures = figures_of(
      "for (name in [\"Syn\", \"Asyn\"]) {\n"
      "    figure(\"position\")\n"
      "    plot([0s, 1s], [0deg, 1deg], label: name)\n"
      "    figure(\"speed\")\n"
      "    plot([0s, 1s], [0deg, 1deg] / 1s, label: name)\n"
      "}\n");
  REQUIRE(figures.size() == 2);
  for (const Figure& figure : figures) {
    CHECK(figure.series.size() == 2);
    CHECK(figure.series[1].label == "Asyn");
  }
}

TEST_CASE("a listener receives a figure when it begins and whenever it changes") {
  const Figures heard = heard_of(
      "wait(1s)\n"
      "figure(\"a\"); plot([1, 2], [3, 4]); scatter([1, 2], [3, 4])\n"
      "figure(\"b\"); bars([\"one\", \"two\"], [3.0, 4.0])\n"
      "figure(\"a\"); plot([1, 2], [1, 2; 3, 4])\n"
      "try { plot([1, 2], [3m, 4m]) } catch (e) { print(\"refused\") }\n"
      "figure(\"a\", log: \"y\")\n"
      "figure(\"c\"); scatter3([[1m, 2m, 3m]])\n");
  CHECK(heard.told == std::vector<Told>{{0, "a", 0},
                                        {0, "a", 1},
                                        {0, "a", 2},
                                        {1, "b", 0},
                                        {1, "b", 1},
                                        {0, "a", 4},
                                        {0, "a", 4},
                                        {2, "c", 0},
                                        {2, "c", 1}});
  REQUIRE(heard.figures.size() == 3);
  CHECK(heard.changed.at(0).y.log);
}

TEST_CASE("of figures that change before the run begins only the last state is reported") {
  const Figures heard = heard_of(
      "figure(\"a\"); plot([1, 2], [3, 4]); plot([1, 2], [5, 6])\n"
      "figure(\"b\"); plot([1, 2], [3, 4])\n"
      "wait(1s)\n"
      "plot([1, 2], [5, 6])\n");
  CHECK(heard.told == std::vector<Told>{{0, "a", 2}, {1, "b", 1}, {1, "b", 2}});
}

TEST_CASE("points in space come from lists of three lengths") {
  const auto figures = figures_of("scatter3([[1m, 2m, 3m], [4m, 5m, 6m]], title: \"cloud\")\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].is_spatial());
  CHECK(figures[0].z.unit == "m");
  CHECK(figures[0].series[0].z == std::vector<double>{3, 6});
}

TEST_CASE("figures are saved as pictures and as text, the same every time") {
  const fs::path folder = fs::temp_directory_path() / "armlet_plot_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string program =
      "figure(\"one\"); plot([0s, 1s], [0deg, 90deg], label: \"first\")\n"
      "figure(\"two\"); plot([0s, 1s], [0m, 2m], label: \"second\")\n"
      "savePlot(\"both.svg\"); savePlot(\"one.svg\", figure: \"one\"); savePlot(\"both.txt\")\n";
  figures_of(program, folder);
  const std::string both = text_of(folder / "both.svg");
  CHECK(both.find(">first<") != std::string::npos);
  CHECK(both.find(">second<") != std::string::npos);
  CHECK(text_of(folder / "one.svg").find(">second<") == std::string::npos);
  CHECK(text_of(folder / "both.txt").find("second") != std::string::npos);
  figures_of(program, folder);
  CHECK(text_of(folder / "both.svg") == both);
  fs::remove_all(folder);
}

TEST_CASE("a trajectory is drawn in three panels, metres on an axis of their own") {
  const auto figures = figures_of(
      "robot arm = robots.scara()\n"
      "let tr = trajectory(\"Trap\", [home(), posJ(90deg, 60deg, 100mm, 45deg)], time: 2s)\n"
      "figure(\"all\"); plot(tr)\n"
      "figure(\"named\"); plot(tr, label: [\"a\", \"b\", \"c\", \"d\"])\n"
      "figure(\"compared\")\n"
      "plot(tr, joint: 2, label: \"one\"); plot(tr.reversed(), joint: 2, label: \"two\")\n");
  REQUIRE(figures.size() == 3);
  REQUIRE(figures[0].panels.size() == 3);
  const std::string per[] = {"", "/s", "/s^2"};
  for (std::size_t order = 0; order < 3; ++order) {
    const Figure& panel = figures[0].panels[order];
    CHECK(panel.x.unit == "s");
    CHECK(panel.y.unit == "rad" + per[order]);
    CHECK(panel.right.unit == "m" + per[order]);
    REQUIRE(panel.series.size() == 4);
    CHECK(panel.series[2].right);
    CHECK_FALSE(panel.series[3].right);
    CHECK(panel.series[0].label == "joint 1");
    CHECK(panel.series[0].x.back() == 2.0);
  }
  CHECK(figures[0].panels[0].series[0].y.back() == doctest::Approx(1.5707963));
  // Constant acceleration from the first instant, and the opposite one up to the last.
  const std::vector<double>& qdd = figures[0].panels[2].series[0].y;
  CHECK(qdd.front() > 0.1);
  CHECK(qdd.back() == doctest::Approx(-qdd.front()));
  CHECK(figures[1].panels[0].series[3].label == "d");
  CHECK(figures[2].panels[1].series.size() == 2);
  CHECK(figures[2].panels[1].series[1].label == "two");
}

TEST_CASE("an arm that only slides has its metres on the left") {
  const auto figures = figures_of(
      "robot gantry { joint prismatic(limits: [0mm, 500mm])\n"
      "               joint prismatic(limits: [0mm, 500mm], alpha: 90deg) }\n"
      "plot(trajectory(\"Syn\", [posJ(0mm, 0mm), posJ(200mm, 100mm)], time: 2s))\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].panels[0].y.unit == "m");
  CHECK_FALSE(figures[0].panels[0].series[1].right);
}

TEST_CASE("columns of a matrix and lists of a list are lines, with names or without") {
  const auto figures = figures_of(
      "robot arm = robots.scara()\n"
      "let t = [0s, 1s, 2s]\n"
      "figure(\"m\"); plot(t, [0, 1; 2, 3; 4, 5], label: [\"a\", \"b\"], yUnit: \"rad\")\n"
      "figure(\"l\"); plot(t, [[1mm, 2mm, 3mm], [4mm, 5mm, 6mm]])\n"
      "figure(\"q\"); plot([0s, 1s], [home(), posJ(90deg, 60deg, 100mm, 45deg)])\n"
      "figure(\"y\"); plot([1mm, 2mm, 4mm], label: \"heights\")\n");
  REQUIRE(figures[0].series.size() == 2);
  CHECK(figures[0].series[1].y == std::vector<double>{1, 3, 5});
  CHECK(figures[0].series[1].label == "b");
  CHECK(figures[0].y.unit == "rad");
  CHECK(figures[1].series[1].y == std::vector<double>{0.004, 0.005, 0.006});
  CHECK(figures[1].y.unit == "m");
  REQUIRE(figures[2].series.size() == 4);
  CHECK(figures[2].series[0].label == "joint 1");
  REQUIRE(figures.size() == 4);
  CHECK(figures[3].series[0].x == std::vector<double>{0, 1, 2});
  CHECK(figures[3].y.unit == "m");
}

TEST_CASE("every column of a record has a panel with its unit") {
  const auto figures = figures_of(
      "robot arm = robots.scara()\n"
      "record run every (500ms) { q: joints(); place: here(); speed: here().x / 1s\n"
      "    note: \"text\"; on: now() > 1s; count: 3; tau: [1Nm, 2Nm] }\n"
      "moveJ(posJ(30deg, 0deg, 0mm, 0deg), time: 2s)\n"
      "plot(run)\n");
  REQUIRE(figures.size() == 1);
  const auto& panels = figures[0].panels;
  REQUIRE(panels.size() == 6);  // without the text
  const char* titles[] = {"q", "place", "speed", "on", "count", "tau"};
  const std::size_t lines[] = {4, 3, 1, 1, 1, 2};
  const char* units[] = {"rad", "m", "m/s", "", "", "Nm"};
  for (std::size_t k = 0; k < panels.size(); ++k) {
    CAPTURE(titles[k]);
    CHECK(panels[k].title == titles[k]);
    CHECK(panels[k].series.size() == lines[k]);
    CHECK(panels[k].y.unit == units[k]);
    CHECK(panels[k].series[0].x == std::vector<double>{0, 0.5, 1, 1.5, 2});
  }
  CHECK(panels[0].series[2].right);
  CHECK(panels[1].series[2].label == "place.z");
  CHECK(panels[3].series[0].y == std::vector<double>{0, 0, 0, 1, 1});
}

TEST_CASE("bars of the same name stand together, whatever their order") {
  const auto figures = figures_of(
      "bars([\"base\", \"elbow\", \"base\"], [1Nm, 2Nm, 3Nm], label: \"a\")\n"
      "bars([\"elbow\", \"wrist\", \"base\"], [4Nm, 5Nm, 6Nm], label: \"b\")\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].names == std::vector<std::string>{"base", "elbow", "base", "wrist"});
  CHECK(figures[0].series[0].x == std::vector<double>{0, 1, 2});
  CHECK(figures[0].series[1].x == std::vector<double>{1, 3, 0});
  CHECK(figures[0].y.unit == "Nm");
}

TEST_CASE("logarithmic axes belong to their figure") {
  const auto figures = figures_of(
      "figure(\"both\", log: \"xy\"); plot([1, 10], [1, 100])\n"
      "figure(\"none\"); plot([1, 10], [1, 100])\n"
      "figure(\"later\"); plot([1, 10], [1, 100]); figure(\"later\", log: \"y\")\n"
      "figure(\"both\"); plot([2, 3], [4, 5])\n");
  REQUIRE(figures.size() == 3);
  CHECK_FALSE(figures[0].y.log);
  CHECK(figures[1].y.log);
  CHECK_FALSE(figures[1].x.log);
  CHECK(figures[2].x.log);
  CHECK(figures[2].y.log);
}

TEST_CASE("a matrix of three columns is a cloud in space") {
  const auto figures = figures_of("scatter3([1, 2, 3; 4, 5, 6], title: \"cloud\", unit: \"m\")\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].series[0].z == std::vector<double>{3, 6});
  CHECK(figures[0].x.unit == "m");
}

TEST_CASE("what is refused leaves the figure as it was") {
  const auto figures = figures_of(
      "robot arm = robots.scara()\n"
      "let t = [1s, 2s]\n"
      "figure(\"a\", log: \"y\")\n"
      "try { plot(t, [1, 2; 3, 0]) } catch (e) { }\n"
      "try { plot(trajectory(\"Syn\", [home(), posJ(9deg, 0deg, 0mm, 0deg)])) } catch (e) { }\n"
      "plot(t, [4, 5])\n");
  REQUIRE(figures.size() == 1);
  CHECK(figures[0].series.size() == 1);
  CHECK(figures[0].panels.empty());
}

TEST_CASE("a program does not run out of the memory of its host with figures") {
  Session session(library_engine(), SessionOptions{});
  REQUIRE(session.compile("let x = linspace(0.0, 1.0, 100000)\nwhile (true) { plot(x, x) }\n",
                          "figures.rbt"));
  const RunResult result = session.run();
  REQUIRE(result.error);
  CHECK(result.error->message.find("at most 5000000 values") != std::string::npos);
}
