#include "armlet/backend/run_hash.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <set>

using namespace armlet;

namespace {

std::uint64_t hash_of(const Event& event) {
  RunHash hash;
  hash.on(event);
  return hash.value();
}

}  // namespace

TEST_CASE("every field that tells runs apart changes the hash") {
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
  std::set<std::uint64_t> hashes;
  for (const Event& event : events) hashes.insert(hash_of(event));
  CHECK(hashes.size() == events.size());
}

TEST_CASE("what only some listeners want does not count") {
  const std::vector<Eigen::Isometry3d> links(2, Eigen::Isometry3d::Identity());
  CHECK(hash_of(JointSample{.T_world_links = links}) == hash_of(JointSample{}));
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
