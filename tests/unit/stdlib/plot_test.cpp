// Figures of programs: their units, their files, and what backends are told.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "armlet/backend/backend.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

class Figures : public Backend {
 public:
  void begin(const RunInfo&) override { began = true; }
  void figure(std::int64_t, const Figure& each) override {
    CHECK(began);
    figures.push_back(each);
  }
  void end(std::int64_t) override { ended_after = figures.size(); }

  bool began = false;
  std::size_t ended_after = 0;
  std::vector<Figure> figures;
};

std::vector<Figure> figures_of(const std::string& program, const fs::path& folder = {}) {
  Figures backend;
  SessionOptions options;
  options.backends = {&backend};
  options.folder = folder;
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(program, "figures.rbt"));
  const RunResult result = session.run();
  if (result.error) MESSAGE(result.error->message);
  REQUIRE(result.status == RunStatus::kDone);
  CHECK(backend.ended_after == backend.figures.size());
  return backend.figures;
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

TEST_CASE("a program does not run out of the memory of its host with figures") {
  Session session(library_engine(), SessionOptions{});
  REQUIRE(session.compile("let x = linspace(0.0, 1.0, 100000)\nwhile (true) { plot(x, x) }\n",
                          "figures.rbt"));
  const RunResult result = session.run();
  REQUIRE(result.error);
  CHECK(result.error->message.find("at most 5000000 values") != std::string::npos);
}
