#include "armlet/backend/jsonl_backend.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "run.hpp"

using namespace armlet;

TEST_CASE("every line is JSON and numbers read back to the same bits") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  play_short_run(*backend);
  CHECK(backend->error().empty());
  std::istringstream lines(out.str());
  std::vector<nlohmann::json> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(nlohmann::json::parse(line));
  REQUIRE(rows.size() == 11);
  CHECK(rows[0]["what"] == "begin");
  CHECK(rows[0]["robots"][0]["joints"] == nlohmann::json({"rad", "m"}));
  CHECK(rows[1]["what"] == "added");
  CHECK(rows[1]["size"] == nlohmann::json({0.04, 0.04, 0.04}));
  CHECK(rows[1]["mass"] == 0.2);
  CHECK(rows[2]["name"] == "arm");
  CHECK(rows[2]["t"] == 0.01);
  CHECK(rows[2]["qd"][0].get<double>() == 1.0 / 3.0);
  CHECK(rows[2]["p"] == nlohmann::json({1.0, 2.0, 3.0}));
  CHECK(rows[2]["r"] == nlohmann::json({1.0, 0.0, 0.0, 0.0}));
  CHECK(rows[3]["what"] == "attached");
  CHECK(rows[3]["robot"] == "left");
  CHECK(rows[4]["what"] == "object");
  CHECK(rows[6]["what"] == "removed");
  CHECK_FALSE(rows[6].contains("robot"));
  CHECK(rows[7]["text"] == "say \"hi\",\n now");
  CHECK(rows[8]["what"] == "advice");
  CHECK(rows[9]["what"] == "robotAdded");
  CHECK(rows[9]["name"] == "late");
  CHECK(rows[10]["t"] == 3.0);
}

TEST_CASE("an arm is described so that it can be drawn, at the beginning and when it changes") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  RobotInfo arm{.name = "arm", .joints = {{.lower = -2, .upper = 2, .max_speed = 3}, {}}};
  arm.joints[0].T_joint_link.translation() = Eigen::Vector3d(0.5, 0, 0.25);
  arm.joints[0].mesh = "upper arm.stl";
  arm.joints[1] = {.unit = JointUnit::kMetre,
                   .lower = -std::numeric_limits<double>::infinity(),
                   .upper = std::numeric_limits<double>::infinity()};
  arm.home = {0.5, 0};
  arm.T_world_base.translation().x() = 2;
  backend->on(BeginRun{.run = {.robots = {arm}, .objects = {}}});
  arm.tool = {.kind = "gripper", .stroke = 0.1, .length = 0.125};
  arm.tool.T_flange_tool.translation().z() = 0.125;
  backend->on(RobotChanged{.t_ns = 1'000'000'000, .robot = arm});
  backend->on(EndRun{});
  std::istringstream lines(out.str());
  std::string line;
  std::getline(lines, line);
  nlohmann::json robot = nlohmann::json::parse(line)["robots"][0];
  CHECK(robot["joints"] == nlohmann::json({"rad", "m"}));
  REQUIRE(robot["links"].size() == 2);
  CHECK(robot["links"][0]["before"] == nlohmann::json({0, 0, 0, 1, 0, 0, 0}));
  CHECK(robot["links"][0]["after"] == nlohmann::json({0.5, 0, 0.25, 1, 0, 0, 0}));
  CHECK(robot["links"][0]["limits"] == nlohmann::json({-2, 2}));
  CHECK(robot["links"][0]["speed"] == 3);
  CHECK(robot["links"][0]["mesh"] == "upper arm.stl");
  CHECK(robot["links"][1]["limits"] == nlohmann::json({nullptr, nullptr}));
  CHECK_FALSE(robot["links"][1].contains("mesh"));
  CHECK(robot["home"] == nlohmann::json({0.5, 0}));
  CHECK(robot["base"] == nlohmann::json({2, 0, 0, 1, 0, 0, 0}));
  CHECK(robot["tool"]["kind"] == "none");
  std::getline(lines, line);
  robot = nlohmann::json::parse(line);
  CHECK(robot["t"] == 1.0);
  CHECK(robot["what"] == "robotChanged");
  CHECK(robot["name"] == "arm");
  CHECK(robot["links"].size() == 2);
  CHECK(robot["tool"]["kind"] == "gripper");
  CHECK(robot["tool"]["stroke"] == 0.1);
  CHECK(robot["tool"]["length"] == 0.125);
  CHECK(robot["tool"]["pose"] == nlohmann::json({0, 0, 0.125, 1, 0, 0, 0}));
}

TEST_CASE("a stream that cannot be written is reported") {
  std::ofstream full("/dev/full");
  const std::unique_ptr<Backend> backend = make_jsonl_backend(full);
  play_short_run(*backend);
  CHECK_FALSE(backend->error().empty());
}

TEST_CASE("a figure is one line, and what is no number is null") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  Figure figure{.title = "speed", .x = {"time", "s"}, .y = {"", "rad/s"}};
  const double inf = std::numeric_limits<double>::infinity();
  figure.series.push_back(
      {.kind = SeriesKind::kPoints, .label = "joint 1", .x = {0, 1}, .y = {0.1, inf}});
  backend->on(FinalFigure{.t_ns = 2'000'000'000, .figure = &figure});
  backend->on(EndRun{.t_ns = 2'000'000'000});
  const nlohmann::json row = nlohmann::json::parse(out.str().substr(0, out.str().find('\n')));
  CHECK(row["t"] == 2.0);
  CHECK(row["what"] == "figure");
  CHECK(row["title"] == "speed");
  CHECK(row["y"] == "rad/s");
  CHECK(row["series"][0]["kind"] == "points");
  CHECK(row["series"][0]["label"] == "joint 1");
  CHECK(row["series"][0]["y"] == nlohmann::json({0.1, nullptr}));
}

TEST_CASE(
    "panels of a figure are figures inside, with names and logarithmic axes where there are") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  Figure figure{.title = "run"};
  figure.panels.push_back({.title = "q", .x = {"time", "s"}, .y = {.unit = "rad", .log = true}});
  figure.panels[0].series.push_back({.label = "q1", .x = {0}, .y = {1}});
  figure.panels[0].names = {"a", "b"};
  backend->on(FinalFigure{.figure = &figure});
  backend->on(EndRun{});
  const nlohmann::json row = nlohmann::json::parse(out.str().substr(0, out.str().find('\n')));
  CHECK(row["series"].empty());
  CHECK(row["panels"][0]["title"] == "q");
  CHECK(row["panels"][0]["y"] == "rad");
  CHECK(row["panels"][0]["log"] == "y");
  CHECK(row["panels"][0]["names"] == nlohmann::json({"a", "b"}));
  CHECK(row["panels"][0]["series"][0]["label"] == "q1");
}

TEST_CASE("a mark says from which line on the file is undone") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  std::uint64_t number = 0;
  backend->on(BeginRun{.run = {.robots = {}, .objects = {{.name = "cube"}, {.name = "ball"}}}});
  for (const char* text : {"one", "two"})
    backend->on(Note{.t_ns = 1'000'000'000, .number = ++number, .text = text});
  number += 2;  // figures, which have no lines
  backend->on(Note{.t_ns = 2'000'000'000, .number = number, .text = "three"});
  backend->on(Undone{.t_ns = 3'000'000'000, .number = 5, .from = 2, .back_ns = 1'000'000'000});
  backend->on(Note{.t_ns = 1'500'000'000, .number = 2, .text = "again"});
  backend->on(Undone{.t_ns = 1'500'000'000, .number = 3, .from = 1, .back_ns = 0});
  backend->on(Undone{.t_ns = 0, .number = 1, .from = 3, .back_ns = 1'500'000'000});
  backend->on(EndRun{.t_ns = 1'500'000'000, .number = 3});
  std::istringstream lines(out.str());
  std::vector<nlohmann::json> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(nlohmann::json::parse(line));
  REQUIRE(rows.size() == 11);
  CHECK(rows[4]["text"] == "two");
  CHECK(rows[6] == nlohmann::json({{"t", 3.0}, {"what", "undone"}, {"line", 5.0}, {"back", 1.0}}));
  CHECK(rows[7]["text"] == "again");
  CHECK(rows[8]["line"] == 4.0);
  CHECK(rows[9] == nlohmann::json({{"t", 0.0}, {"what", "redone"}, {"back", 1.5}}));
}

TEST_CASE("cameras and their pictures are lines with the hash of the pixels") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_jsonl_backend(out);
  CameraInfo eye{.name = "eye", .width = 2, .height = 1, .fx = 3.5, .fy = 3.5, .far = 20.0};
  eye.robot = 0;
  backend->on(BeginRun{.run = {.robots = {{.name = "arm"}}, .objects = {}, .cameras = {eye}}});
  backend->on(CameraAdded{.t_ns = 5, .camera = {.name = "late", .rate = 25.0, .object = "cart"}});
  const std::uint8_t pixels[] = {1, 2, 3, 4, 5, 6};
  ImageFrame frame{.t_ns = 40'000'000, .camera = "eye", .frame = 3, .width = 2, .height = 1};
  frame.pixels = pixels;
  frame.T_world_camera.translation().z() = 0.5;
  backend->on(frame);
  frame.file = "frames/eye-000003.png";
  backend->on(frame);
  backend->on(EndRun{});
  std::istringstream lines(out.str());
  std::vector<nlohmann::json> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(nlohmann::json::parse(line));
  REQUIRE(rows.size() == 5);
  CHECK(rows[0]["cameras"][0]["name"] == "eye");
  CHECK(rows[0]["cameras"][0]["size"] == nlohmann::json({2, 1}));
  CHECK(rows[0]["cameras"][0]["K"] == nlohmann::json({3.5, 3.5, 0.0, 0.0}));
  CHECK(rows[0]["cameras"][0]["robot"] == "arm");
  CHECK_FALSE(rows[0]["cameras"][0].contains("rate"));
  CHECK(rows[1]["what"] == "cameraAdded");
  CHECK(rows[1]["rate"] == 25.0);
  CHECK(rows[1]["object"] == "cart");
  CHECK(rows[2]["what"] == "frame");
  CHECK(rows[2]["camera"] == "eye");
  CHECK(rows[2]["number"] == 3);
  CHECK(rows[2]["size"] == nlohmann::json({2, 1, 3}));
  // FNV-1a of the bytes 1 to 6, computed from the definition in Python.
  CHECK(rows[2]["hash"] == "9746a713f3a6584a");
  CHECK(rows[2]["p"] == nlohmann::json({0.0, 0.0, 0.5}));
  CHECK_FALSE(rows[2].contains("file"));
  CHECK(rows[3]["file"] == "frames/eye-000003.png");
}
