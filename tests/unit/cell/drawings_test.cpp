// Shapes that are only shown: they go with what they are on, and nothing else knows them.
#include <doctest/doctest.h>

#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// Keeps what a run says of shapes.
class DrawingListener : public Backend {
 public:
  void on(const Event& event) override {
    if (const auto* changed = std::get_if<DrawingChanged>(&event)) heard.push_back(*changed);
    began = began || kind_of(event) == EventKind::kBeginRun;
    CHECK((began || heard.empty()));
  }
  std::vector<DrawingChanged> heard;
  bool began = false;
};

Drawing line(std::string name, const Mount& on,
             const Isometry3d& T = make_translation({0.1, 0, 0})) {
  return {.name = std::move(name),
          .kind = DrawingKind::kLine,
          .size = {0.2, 0.01, 0.0},
          .on = on,
          .T_on_drawing = T};
}

double distance_of_poses(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("shapes go with the world, a body, a link and the tool point") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  cell.insert({.name = "cube", .shape = Box{}, .T_world_obj = make_translation({0.5, 0.2, 0.3})});
  cell.insert_frame({.name = "corner",
                     .base = FrameBase::kObject,
                     .on = "cube",
                     .T_on_frame = make_translation({0.0, 0.0, 0.02})});
  const Isometry3d T = make_translation({0.1, 0, 0});
  cell.draw(line("world", {}));
  cell.draw(line("cube", {.base = FrameBase::kObject, .on = "cube"}));
  cell.draw(line("corner", {.base = FrameBase::kFrame, .on = "corner"}));
  for (int frame = 0; frame <= 6; ++frame) {
    cell.draw(line("link" + std::to_string(frame),
                   {.base = FrameBase::kCarrier, .carrier = arm, .frame = frame}));
  }
  cell.draw(line("tip", {.base = FrameBase::kCarrier, .carrier = arm, .frame = kTipFrame}));
  const auto check = [&] {
    CHECK(distance_of_poses(cell.T_world_drawing("world"), T) == 0.0);
    const Isometry3d T_world_cube = cell.world().at("cube").T_world_obj;
    CHECK(distance_of_poses(cell.T_world_drawing("cube"), T_world_cube * T) < 1e-14);
    CHECK(distance_of_poses(cell.T_world_drawing("corner"),
                            T_world_cube * make_translation({0.1, 0.0, 0.02})) < 1e-14);
    for (int frame = 0; frame <= 6; ++frame) {
      CHECK(distance_of_poses(cell.T_world_drawing("link" + std::to_string(frame)),
                              cell.T_world_link(arm, frame) * T) < 1e-14);
    }
    CHECK(distance_of_poses(cell.T_world_drawing("tip"), cell.T_world_tool(arm) * T) < 1e-14);
  };
  check();
  Eigen::VectorXd q = cell.robot(arm).q;
  for (int i = 0; i < 6; ++i) q[i] += 0.2 + 0.05 * i;
  cell.set_joints(arm, q);
  cell.set_pose("cube", make_translation({-0.4, 0.1, 0.6}));
  check();
}

TEST_CASE("shapes are no bodies: the world, and what collides, is as without them") {
  Cell cell(World(0.0));
  const int arm = cell.add_robot(make_robot("ur5"), "arm");
  cell.insert({.name = "cube", .shape = Box{}, .T_world_obj = make_translation({0.6, 0.0, 0.02})});
  cell.draw({.name = "wall",
             .kind = DrawingKind::kCapsule,
             .size = {0.5, 1.0, 0.0},
             .T_on_drawing = cell.T_world_tool(arm)});
  CHECK(cell.world().size() == 1);
  CHECK(cell.world().find("wall") == nullptr);
  CHECK(cell.presses(arm).empty());
}

TEST_CASE("a backend receives shapes after the start, and when they change or go") {
  Cell cell;
  DrawingListener listener;
  cell.set_backend(&listener);
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  cell.insert({.name = "cube", .shape = Box{}});
  cell.draw(line("a", {}));
  cell.draw(line("a", {.base = FrameBase::kCarrier, .carrier = arm, .frame = kTipFrame}));
  CHECK(listener.heard.empty());
  cell.begin();
  REQUIRE(listener.heard.size() == 1);
  CHECK(listener.heard[0].drawing.name == "a");
  CHECK(listener.heard[0].drawing.kind == "line");
  CHECK(listener.heard[0].drawing.robot == arm);
  CHECK(listener.heard[0].drawing.link == kDrawingTip);
  cell.advance_to(1'000'000);
  cell.draw(line("b", {.base = FrameBase::kObject, .on = "cube"}));
  CHECK(listener.heard.back().drawing.object == "cube");
  CHECK(listener.heard.back().t_ns == 1'000'000);
  cell.remove("cube");
  CHECK(listener.heard.back().removed);
  CHECK(listener.heard.back().drawing.name == "b");
  CHECK(cell.drawings().find("b") == nullptr);
  CHECK(cell.undraw("a"));
  CHECK(listener.heard.back().drawing.name == "a");
  CHECK_FALSE(cell.undraw("a"));
}

TEST_CASE("a shape on what is not there is refused") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  CHECK_THROWS_AS(cell.draw(line("a", {.base = FrameBase::kObject, .on = "none"})), ArgumentError);
  CHECK_THROWS_AS(cell.draw(line("a", {.base = FrameBase::kFrame, .on = "none"})), ArgumentError);
  CHECK_THROWS_AS(cell.draw(line("a", {.base = FrameBase::kCarrier, .carrier = arm, .frame = 7})),
                  ArgumentError);
  CHECK_THROWS_AS(cell.draw(line("a", {.base = FrameBase::kCarrier, .carrier = 3, .frame = 0})),
                  ArgumentError);
  CHECK_THROWS_AS((void)cell.T_world_drawing("a"), ArgumentError);
  CHECK(cell.drawings().size() == 0);
}
