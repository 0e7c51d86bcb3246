#include "armlet/stdlib/install.hpp"

#include <doctest/doctest.h>

#include <string>

#include "armlet/interpreter/reference.hpp"
#include "armlet/stdlib/session.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/vision/opencv.hpp"
#include "library.hpp"
#include "messages/foreign_names.hpp"
#include "values/bind.hpp"

using namespace armlet;

namespace {

SessionOptions options(std::string& printed) {
  SessionOptions made = at_the_table();
  made.output = [&printed](std::string_view text) { printed += text; };
  return made;
}

// What has to stand in front of an example for it to make sense.
std::string before(std::string_view name) {
  if (name == "grasp") return "moveJ(topGrasp(object(\"cube\")), time: 2s)\n";
  if (name == "release") return before("grasp") + "grasp()\n";
  return {};
}

void check_example(const NativeFunction& function) {
  std::string text(function.example);
  if (function.name.starts_with("robot.joint.") || function.name.starts_with("robot.body."))
    text = "robot one { " + text + " }";
  if (function.name.starts_with("lab."))
    text = "robot arm = robots.scara()\ncamera eye { on: arm }\nlab one { " + text + " }";
  std::string printed;
  Session session(library_engine(), options(printed));
  bool compiled = session.compile(before(function.name) + text, "example.rbt");
  // A value alone is no statement.
  if (!compiled && session.problems().front().diagnostic.code == "E0332") {
    compiled = session.compile(before(function.name) + "print(" + text + ")", "example.rbt");
  }
  for (const Problem& problem : session.problems()) {
    if (problem.diagnostic.severity == Severity::kError) FAIL_CHECK(problem.diagnostic.message);
  }
  // No folder is granted here.
  if (!compiled || function.name == "save" || function.name == "savePlot" ||
      function.name == "snapshot" || function.name == "urdf" || function.name == "mesh" ||
      function.name == "loadTable" || function.name == "loadImage" ||
      function.name == "robot.body.mesh")
    return;
  const RunResult result = session.run();
  if (result.error && result.error->code == "R0691" && !has_opencv()) return;
  CHECK(result.status == Progress::kDone);
  if (result.error) FAIL_CHECK(result.error->message);
}

}  // namespace

TEST_CASE("every signature of the library can be read") {
  for (const std::string& wrong : library_engine().check_signatures()) FAIL_CHECK(wrong);
}

TEST_CASE("every function that people see has one line of help and an example that runs") {
  for (const bind::Chapter& chapter : bind::chapters()) {
    CHECK_FALSE(chapter.functions.empty());
    for (const NativeFunction& function : chapter.functions) {
      if (function.help.empty()) continue;  // only there to be explained, or not yet
      CAPTURE(function.name);
      CAPTURE(function.signature);
      CHECK_FALSE(function.example.empty());
      CHECK(function.example.find('\n') == std::string_view::npos);
      check_example(function);
    }
  }
}

TEST_CASE("what another language calls a name of the library stands for one that there is") {
  for (const ForeignName& row : bind::kForeignNames) {
    CAPTURE(row.foreign);
    CHECK((!row.here.empty() || !row.note.empty()));
    if (row.kind != ForeignKind::kName || row.here.empty()) continue;
    CHECK_FALSE(help_page(library_engine(), row.here).empty());
  }
}

TEST_CASE("the help of moveSpline names the planners that lay a curve through poses") {
  const std::string page = help_page(library_engine(), "moveSpline");
  for (const PlannerRow& row : planner_rows()) {
    CAPTURE(row.name);
    CHECK((page.find('"' + std::string(row.name) + '"') != std::string::npos) ==
          row.in_space.has_value());
  }
}
