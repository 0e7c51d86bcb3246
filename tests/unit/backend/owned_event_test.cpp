#include "armlet/backend/owned_event.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

using namespace armlet;

namespace {

// A copy of an event that `make` builds from values which are gone and overwritten afterwards.
template <class Make>
std::unique_ptr<const OwnedEvent> copy_of(Make make) {
  return make([](const Event& event) { return std::make_unique<const OwnedEvent>(event); });
}

template <class T>
const T& as(const std::unique_ptr<const OwnedEvent>& owned) {
  return std::get<T>(owned->event());
}

}  // namespace

TEST_CASE("a copy of a sample of joints has numbers and poses of its own") {
  const auto owned = copy_of([](auto copy) {
    std::vector<double> q{1, 2, 3}, qd{4, 5, 6}, qdd{7, 8, 9};
    std::vector<Eigen::Isometry3d> links(3, Eigen::Isometry3d::Identity());
    links[2].translation().x() = 0.5;
    auto made = copy(JointSample{.t_ns = 5,
                                 .number = 6,
                                 .robot = 1,
                                 .motion = 2,
                                 .q = q,
                                 .qd = qd,
                                 .qdd = qdd,
                                 .T_world_links = links});
    for (std::vector<double>* each : {&q, &qd, &qdd}) each->assign(3, -1.0);
    links.assign(3, Eigen::Isometry3d::Identity());
    return made;
  });
  const auto& sample = as<JointSample>(owned);
  CHECK(sample.t_ns == 5);
  CHECK(sample.number == 6);
  CHECK(sample.robot == 1);
  CHECK(sample.motion == 2);
  CHECK(std::vector(sample.q.begin(), sample.q.end()) == std::vector<double>{1, 2, 3});
  CHECK(std::vector(sample.qd.begin(), sample.qd.end()) == std::vector<double>{4, 5, 6});
  CHECK(std::vector(sample.qdd.begin(), sample.qdd.end()) == std::vector<double>{7, 8, 9});
  REQUIRE(sample.T_world_links.size() == 3);
  CHECK(sample.T_world_links[2].translation().x() == 0.5);
}

TEST_CASE("a copy has names, texts and figures of its own") {
  std::string text = "cube";
  Figure figure{.title = "speed"};
  const OwnedEvent sample(ObjectSample{.name = text}), event(ObjectEvent{.name = text}),
      note(Note{.text = text}), changed(FigureChanged{.index = 3, .figure = &figure}),
      final(FinalFigure{.index = 4, .figure = &figure});
  text = "ball";
  figure.title = "force";
  CHECK(std::get<ObjectSample>(sample.event()).name == "cube");
  CHECK(std::get<ObjectEvent>(event.event()).name == "cube");
  CHECK(std::get<Note>(note.event()).text == "cube");
  CHECK(std::get<FigureChanged>(changed.event()).figure->title == "speed");
  CHECK(std::get<FigureChanged>(changed.event()).index == 3);
  CHECK(std::get<FinalFigure>(final.event()).figure->title == "speed");
}

TEST_CASE("a copy of a picture has names and pixels of its own") {
  std::string name = "eye", file = "eye-000000.png";
  std::vector<std::uint8_t> pixels{1, 2, 3, 4, 5, 6};
  const OwnedEvent owned(ImageFrame{
      .camera = name, .frame = 4, .width = 2, .height = 1, .pixels = pixels, .file = file});
  name = "ear";
  file = "ear-000000.png";
  pixels.assign(6, 0);
  const auto& frame = std::get<ImageFrame>(owned.event());
  CHECK(frame.camera == "eye");
  CHECK(frame.file == "eye-000000.png");
  CHECK(frame.frame == 4);
  CHECK(std::vector(frame.pixels.begin(), frame.pixels.end()) ==
        std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
  const OwnedEvent added(CameraAdded{.camera = {.name = "late"}});
  CHECK(std::get<CameraAdded>(added.event()).camera.name == "late");
}

TEST_CASE("events that hold what they say are copied as they are") {
  const OwnedEvent begin(BeginRun{.run = {.robots = {{.name = "arm"}}, .objects = {}}}),
      robot(RobotAdded{.t_ns = 3, .robot = {.name = "late"}}),
      object(ObjectAdded{.object = {.name = "cube"}}), end(EndRun{.t_ns = 9, .number = 10});
  CHECK(std::get<BeginRun>(begin.event()).run.robots[0].name == "arm");
  CHECK(std::get<RobotAdded>(robot.event()).robot.name == "late");
  CHECK(std::get<ObjectAdded>(object.event()).object.name == "cube");
  CHECK(time_of(end.event()) == 9);
  CHECK(number_of(end.event()) == 10);
}
