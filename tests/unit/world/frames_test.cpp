// Frames with names: a tree on the bodies of a world.
#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/world/world.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

NamedFrame frame(std::string name, FrameBase base, std::string on, const Vector3d& p) {
  return {.name = std::move(name),
          .base = base,
          .on = std::move(on),
          .T_on_frame = make_translation(p)};
}

}  // namespace

TEST_CASE("frames move with what they are on, through all that lies between") {
  World world;
  world.insert({.name = "tray", .shape = Box{}, .T_world_obj = make_translation({0.5, 0.0, 0.1})});
  world.insert_frame(frame("rim", FrameBase::kObject, "tray", {0.1, 0.0, 0.0}));
  world.insert_frame(frame("corner", FrameBase::kFrame, "rim", {0.0, 0.2, 0.0}));
  world.insert_frame(frame("cell", FrameBase::kWorld, "", {1.0, 0.0, 0.0}));
  CHECK(world.T_world_frame("corner")->translation().isApprox(Vector3d(0.6, 0.2, 0.1), 1e-15));
  world.set_pose("tray", pose_from_rpy({0.0, 0.0, 0.0}, {0.0, 0.0, M_PI / 2}));
  CHECK(world.T_world_frame("corner")->translation().isApprox(Vector3d(-0.2, 0.1, 0.0), 1e-15));
  // Put elsewhere, it goes on from there, and what is on it goes with it.
  world.set_frame("rim", make_translation({2.0, 0.0, 0.0}));
  CHECK(world.T_world_frame("corner")->translation().isApprox(Vector3d(2.0, 0.2, 0.0), 1e-15));
  world.set_pose("tray", Eigen::Isometry3d::Identity());
  CHECK(world.T_world_frame("rim")->translation().isApprox(Vector3d(0.0, -2.0, 0.0), 1e-15));
  CHECK(world.T_world_frame("cell")->translation() == Vector3d(1.0, 0.0, 0.0));
  CHECK(world.frame_names() == std::vector<std::string>{"rim", "corner", "cell"});
}

TEST_CASE("a frame on what was removed is nowhere") {
  World world;
  world.insert({.name = "tray", .shape = Box{}});
  world.insert_frame(frame("rim", FrameBase::kObject, "tray", {0.1, 0.0, 0.0}));
  world.insert_frame(frame("corner", FrameBase::kFrame, "rim", {0.0, 0.2, 0.0}));
  world.remove("tray");
  CHECK_FALSE(world.T_world_frame("rim"));
  CHECK_FALSE(world.T_world_frame("corner"));
  CHECK_THROWS_AS(world.set_frame("rim", Eigen::Isometry3d::Identity()), ArgumentError);
}

TEST_CASE("a frame needs a name of its own, a pose, and something that is there") {
  World world;
  world.insert_frame(frame("a", FrameBase::kWorld, "", Vector3d::Zero()));
  CHECK_THROWS_AS(world.insert_frame(frame("", FrameBase::kWorld, "", Vector3d::Zero())),
                  ArgumentError);
  CHECK_THROWS_AS(world.insert_frame(frame("a", FrameBase::kWorld, "", Vector3d::Zero())),
                  ArgumentError);
  // On itself, on what comes later, on a body of a frame's name: nothing of this is there.
  CHECK_THROWS_AS(world.insert_frame(frame("b", FrameBase::kFrame, "b", Vector3d::Zero())),
                  ArgumentError);
  CHECK_THROWS_AS(world.insert_frame(frame("b", FrameBase::kObject, "a", Vector3d::Zero())),
                  ArgumentError);
  CHECK_THROWS_AS(world.insert_frame(frame("b", FrameBase::kWorld, "", {std::nan(""), 0.0, 0.0})),
                  ArgumentError);
  CHECK_THROWS_AS(world.insert_frame(frame("b", FrameBase::kWorld, "", {2e4, 0.0, 0.0})),
                  ArgumentError);
  CHECK_THROWS_AS((void)world.T_world_frame("b"), ArgumentError);
  CHECK_THROWS_AS(world.set_frame("b", Eigen::Isometry3d::Identity()), ArgumentError);
  CHECK(world.frame_names().size() == 1);
}
