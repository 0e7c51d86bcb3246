#include "armlet/stdlib/install.hpp"

#include <doctest/doctest.h>

#include <string>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/session.hpp"
#include "bind.hpp"

using namespace armlet;

namespace {

const Engine& engine() {
  static const Engine made = [] {
    Engine e;
    install(e);
    return e;
  }();
  return made;
}

SessionOptions options(std::string& printed) {
  SessionOptions made;
  made.robot = std::make_shared<const Robot>(make_scara());
  made.default_world = table_world();
  made.output = [&printed](std::string_view text) { printed += text; };
  return made;
}

}  // namespace

TEST_CASE("every signature of the library can be read") {
  for (const std::string& wrong : engine().check_signatures()) FAIL_CHECK(wrong);
}

TEST_CASE("every function that people see has one line of help and an example that runs") {
  const auto chapters = {
      bind::math_functions(),    bind::list_functions(),  bind::text_functions(),
      bind::pose_functions(),    bind::model_functions(), bind::robot_functions(),
      bind::motion_functions(),  bind::hand_functions(),  bind::world_functions(),
      bind::classic_functions(), bind::time_functions(),  bind::settings_functions(),
      bind::table_functions()};
  for (const auto& chapter : chapters) {
    for (const NativeFunction& function : chapter) {
      if (function.help.empty()) continue;  // only there to be explained
      CAPTURE(function.name);
      CAPTURE(function.signature);
      CHECK_FALSE(function.example.empty());
      // Rows of blocks and hands that close on nothing cannot stand alone.
      std::string text(function.example);
      if (function.name.starts_with("robot.joint.")) text = "robot one { " + text + " }";
      std::string printed;
      Session session(engine(), options(printed));
      bool compiled = session.compile(text, "example.rbt");
      // A value alone is no statement.
      if (!compiled && session.problems().front().diagnostic.code == "E0332") {
        compiled = session.compile("print(" + text + ")", "example.rbt");
      }
      for (const Problem& problem : session.problems()) {
        if (problem.diagnostic.severity == Severity::kError) FAIL_CHECK(problem.diagnostic.message);
      }
      const bool alone = function.name != "grasp" && function.name != "release";
      if (!compiled || !alone || function.name == "save") continue;  // nor without a folder
      const RunResult result = session.run();
      if (result.error) FAIL_CHECK(result.error->message);
    }
  }
}
