#include "armlet/stdlib/workspace.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "temporary_folder.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, std::string_view text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("a program of a workspace runs with its imports, its robot and its world") {
  const TemporaryFolder place;
  const fs::path program = place.path() / "cell" / "main.rbt";
  const std::string text =
      "import \"parts/size.rbt\"\nprint(size.width)\nprint(objects().length)\n";
  write(program, text);
  write(place.path() / "cell" / "parts" / "size.rbt", "let width = 12mm\n");
  write(place.path() / "world.rbt",
        "object ball { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }\n");
  auto options =
      session_options({program.string(), "ur5", (place.path() / "world.rbt").string(), {}});
  REQUIRE(options.ok());
  CHECK(options->robot->n() == 6);
  CHECK(options->folder == program.parent_path());
  CHECK_FALSE(options->default_world);
  std::string printed;
  SessionOptions chosen = std::move(options).value();
  chosen.output = [&printed](std::string_view more) { printed += more; };
  Session session(library_engine(), std::move(chosen));
  REQUIRE(session.compile(text, program.string()));
  CHECK(session.run().status == Progress::kDone);
  CHECK(printed == "12 mm\n1\n");
}

TEST_CASE("without a world a workspace has the table, and a program cannot leave its folder") {
  const TemporaryFolder place;
  write(place.path() / "secret.rbt", "let key = 1\n");
  write(place.path() / "cell" / "main.rbt", "");
  const std::string program = (place.path() / "cell" / "main.rbt").string();
  const auto options = session_options({program, "scara"});
  REQUIRE(options.ok());
  CHECK(options->default_world);
  CHECK_FALSE(options->load("../secret.rbt", program).text);
  CHECK_FALSE(options->load((place.path() / "secret.rbt").string(), program).text);
  CHECK(options->load("main.rbt", program).text);
}

TEST_CASE("a robot or a world that is not there is an error with its reason") {
  const auto robot = session_options({"main.rbt", "ur55"});
  REQUIRE_FALSE(robot.ok());
  CHECK(robot.error().code == "robot");
  CHECK(robot.error().message.find("there is no robot called \"ur55\"; there are ") == 0);
  CHECK(robot.error().message.find("did you mean \"ur5\"?") != std::string::npos);
  const auto world = session_options({"main.rbt", "ur5", "/nowhere/world.rbt"});
  REQUIRE_FALSE(world.ok());
  CHECK(world.error().code != "robot");
}
