#include "armlet/backend/run_hash.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <memory>
#include <set>
#include <vector>

using namespace armlet;

namespace {

std::uint64_t hash_of(const Event& event) {
  RunHash hash;
  hash.on(event);
  return hash.value();
}

std::size_t different_hashes(const std::vector<Event>& events) {
  std::set<std::uint64_t> hashes;
  for (const Event& event : events) hashes.insert(hash_of(event));
  return hashes.size();
}

}  // namespace

TEST_CASE("every field in which runs differ changes the hash") {
  const double zeros[] = {0.0, 0.0};
  const double ones[] = {0.0, 1.0};
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.translation().x() = 1e-300;
  const Figure line{.series = {{.y = {1.0}}}};
  const Figure none{};
  const std::vector<Event> events = {
      BeginRun{},
      BeginRun{.run = {.robots = {{"a"}}}},
      BeginRun{.run = {.robots = {{"a", {{.upper = 1.0}}}}}},
      BeginRun{.run = {.objects = {{.name = "a"}}}},
      RobotAdded{.robot = {"a"}},
      RobotAdded{.t_ns = 1, .robot = {"a"}},
      RobotChanged{.index = 0, .robot = {"a"}},
      RobotChanged{.index = 1, .robot = {"a"}},
      JointSample{.q = zeros},
      JointSample{.q = ones},
      JointSample{.qd = ones},
      JointSample{.qdd = ones},
      JointSample{.robot = 1, .q = zeros},
      JointSample{.motion = 1, .q = zeros},
      JointSample{.t_ns = 1, .q = zeros},
      JointSample{.q = zeros, .T_world_tool = moved},
      ObjectAdded{.object = {.name = "a"}},
      ObjectAdded{.object = {.name = "a", .mass = 1.0}},
      ObjectSample{.name = "a"},
      ObjectSample{.name = "a", .T_world_obj = moved},
      ObjectEvent{.name = "a"},
      ObjectEvent{.change = ObjectChange::kFell, .name = "a"},
      ObjectEvent{.name = "a", .robot = 1},
      Note{.text = "a"},
      Note{.text = "b"},
      Note{.kind = NoteKind::kAdvice, .text = "a"},
      FinalFigure{.figure = &line},
      FinalFigure{.figure = &none},
      FinalFigure{.index = 1, .figure = &none},
      EndRun{},
      EndRun{.t_ns = 1},
      DrawingChanged{.drawing = {.name = "a"}},
      DrawingChanged{.drawing = {.name = "a"}, .removed = true},
      DrawingChanged{.drawing = {.name = "a", .kind = "line"}},
      DrawingChanged{.drawing = {.name = "a", .size = {1.0, 0.0, 0.0}}},
      DrawingChanged{.drawing = {.name = "a", .text = "b"}},
      DrawingChanged{.drawing = {.name = "a", .color = "red"}},
      DrawingChanged{.drawing = {.name = "a", .robot = 0}},
      DrawingChanged{.drawing = {.name = "a", .link = 2}},
      DrawingChanged{.drawing = {.name = "a", .object = "b"}},
      DrawingChanged{.drawing = {.name = "a", .T_on_drawing = moved}},
  };
  CHECK(different_hashes(events) == events.size());
}

TEST_CASE("what a figure shows as a picture changes the hash") {
  const auto black = std::make_shared<const Image>(2, 1, PixelKind::kGrey);
  Image pixels(2, 1, PixelKind::kGrey);
  pixels.row(0)[1] = 1;
  const Figure figures[] = {
      {},
      {.picture = black},
      {.picture = black, .note = "depths"},
      {.picture = std::make_shared<const Image>(1, 2, PixelKind::kGrey)},
      {.picture = std::make_shared<const Image>(pixels)},
  };
  std::vector<Event> events;
  for (const Figure& figure : figures) events.push_back(FinalFigure{.figure = &figure});
  CHECK(different_hashes(events) == events.size());
}

TEST_CASE("every field of cameras and their pictures changes the hash") {
  const std::uint8_t black[] = {0, 0, 0}, dark[] = {0, 0, 1};
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.translation().x() = 1e-300;
  const std::vector<Event> events = {
      BeginRun{},
      BeginRun{.run = {.robots = {}, .objects = {}, .cameras = {{.name = "a"}}}},
      CameraAdded{.camera = {.name = "a"}},
      CameraAdded{.camera = {.name = "a", .width = 1}},
      CameraAdded{.camera = {.name = "a", .height = 1}},
      CameraAdded{.camera = {.name = "a", .fx = 1.0}},
      CameraAdded{.camera = {.name = "a", .distortion = {0.0, 0.0, 0.1}}},
      CameraAdded{.camera = {.name = "a", .far = 1.0}},
      CameraAdded{.camera = {.name = "a", .rate = 1.0}},
      CameraAdded{.camera = {.name = "a", .robot = 0}},
      CameraAdded{.camera = {.name = "a", .link = 2}},
      CameraAdded{.camera = {.name = "a", .object = "b"}},
      CameraAdded{.camera = {.name = "a", .frame = "b"}},
      CameraAdded{.camera = {.name = "a", .T_on_camera = moved}},
      ImageFrame{.camera = "a", .width = 1, .height = 1, .pixels = black},
      ImageFrame{.camera = "a", .width = 1, .height = 1, .pixels = dark},
      ImageFrame{.camera = "b", .width = 1, .height = 1, .pixels = black},
      ImageFrame{.camera = "a", .frame = 1, .width = 1, .height = 1, .pixels = black},
      ImageFrame{.camera = "a", .width = 3, .height = 1, .channels = 1, .pixels = black},
      ImageFrame{.camera = "a", .width = 1, .height = 3, .channels = 1, .pixels = black},
      ImageFrame{.camera = "a", .width = 1, .height = 1, .pixels = black, .T_world_camera = moved},
  };
  CHECK(different_hashes(events) == events.size());
}

TEST_CASE("what only some listeners want does not count") {
  const std::vector<Eigen::Isometry3d> links(2, Eigen::Isometry3d::Identity());
  CHECK(hash_of(JointSample{.T_world_links = links}) == hash_of(JointSample{}));
  CHECK(hash_of(ImageFrame{.camera = "a", .file = "a-000000.png"}) ==
        hash_of(ImageFrame{.camera = "a"}));
  CHECK(hash_of(Note{.number = 7, .text = "a"}) == hash_of(Note{.text = "a"}));
  const Figure figure{};
  CHECK(hash_of(FigureChanged{.figure = &figure}) == RunHash().value());
}

TEST_CASE("the order of events counts, and the text has 16 digits") {
  RunHash one;
  one.on(Note{.text = "a"});
  one.on(Note{.text = "b"});
  RunHash other;
  other.on(Note{.text = "b"});
  other.on(Note{.text = "a"});
  CHECK(one.value() != other.value());
  CHECK(RunHash().text() == "cbf29ce484222325");
}
