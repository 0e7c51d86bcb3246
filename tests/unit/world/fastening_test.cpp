// Bodies fastened on others and on frames of carriers.
#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/world/world.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

Object body(std::string name, const Vector3d& p, bool fixed = false) {
  return {.name = std::move(name),
          .shape = Box{{0.04, 0.04, 0.04}},
          .T_world_obj = make_translation(p),
          .fixed = fixed};
}

double apart(const World& world, std::string_view name, const Isometry3d& T) {
  return (world.at(name).T_world_obj.matrix() - T.matrix()).cwiseAbs().maxCoeff();
}

Isometry3d random_pose(Random& random) {
  const auto number = [&](double most) { return random.uniform(-most, most); };
  return pose_from_rpy({number(1), number(1), number(1)}, {number(3), number(1.5), number(3)});
}

}  // namespace

TEST_CASE("what is fastened goes where the lower body goes, over any number of bodies") {
  Random random(110);
  for (int round = 0; round < 100; ++round) {
    World world(-5.0);
    world.insert(body("b0", {0.0, 0.0, 0.0}));
    for (int i = 1; i < 6; ++i) {
      Object next = body("b" + std::to_string(i), Vector3d::Zero());
      next.T_world_obj = random_pose(random);
      world.insert(next);
      world.fasten(next.name, "b" + std::to_string(random.below(static_cast<std::uint64_t>(i))));
    }
    std::vector<Isometry3d> T_0_i;
    for (int i = 0; i < 6; ++i)
      T_0_i.push_back(world.at("b0").T_world_obj.inverse() * world.object(i).T_world_obj);
    const auto check = [&] {
      for (std::size_t i = 0; i < 6; ++i)
        CHECK(apart(world, world.object(i).name, world.at("b0").T_world_obj * T_0_i[i]) < 1e-12);
    };
    world.set_pose("b0", random_pose(random));
    check();
    const Isometry3d T_hand = random_pose(random);
    world.attach("b0", 0, T_hand);
    world.move_carried(0, random_pose(random));
    check();
    CHECK(world.carried_by(0) == "b0");
    world.drop("b0");
    check();
    for (std::size_t i = 0; i < 6; ++i) CHECK_FALSE(world.attachment_of(i));
  }
}

TEST_CASE("a thing falls until the first of its parts rests") {
  World world(0.0);
  world.insert(body("plate", {0.0, 0.0, 1.0}));
  world.insert(body("hook", {0.1, 0.0, 0.9}));
  world.fasten("hook", "plate");
  const Drop drop = world.drop("plate");
  CHECK(drop.support == "floor");
  CHECK(drop.distance == doctest::Approx(0.88));
  CHECK(world.at("hook").T_world_obj.translation().z() == doctest::Approx(0.02));
}

TEST_CASE("a gripper takes off what is fastened; what is fixed stays on when it is put elsewhere") {
  World world(0.0);
  world.insert(body("tray", {0.0, 0.0, 0.02}));
  world.insert(body("loose", {0.0, 0.0, 0.06}));
  world.insert(body("part", {0.1, 0.0, 0.06}, true));
  world.fasten("loose", "tray");
  world.fasten("part", "tray");
  world.set_pose("part", make_translation({0.0, 0.1, 0.06}));
  world.set_pose("tray", make_translation({1.0, 0.0, 0.02}));
  CHECK(apart(world, "loose", make_translation({1.0, 0.0, 0.06})) < 1e-15);
  CHECK(apart(world, "part", make_translation({1.0, 0.1, 0.06})) < 1e-15);
  world.attach("loose", 0, Isometry3d::Identity());
  world.set_pose("tray", make_translation({2.0, 0.0, 0.02}));
  CHECK(apart(world, "loose", make_translation({1.0, 0.0, 0.06})) < 1e-15);
  world.drop("loose");
  world.set_pose("tray", make_translation({0.0, 0.0, 0.02}));
  CHECK(world.at("loose").T_world_obj.translation().z() == doctest::Approx(0.02));
}

TEST_CASE("what was fastened on a body that is removed falls, and stays if it is fixed") {
  World world(0.0);
  world.insert(body("tray", {0.0, 0.0, 0.5}));
  world.insert(body("loose", {0.0, 0.0, 0.54}));
  world.insert(body("part", {0.2, 0.0, 0.54}, true));
  world.insert(body("upper", {0.2, 0.0, 0.58}));
  world.fasten("loose", "tray");
  world.fasten("part", "tray");
  const auto falls = world.remove("tray");
  REQUIRE(falls.size() == 1);
  CHECK(falls[0].name == "loose");
  CHECK(world.resting_on("upper") == "part");
  // It belongs to nothing that comes later, whatever its name.
  world.insert(body("tray", {0.0, 0.0, 2.0}));
  world.set_pose("tray", make_translation({1.0, 0.0, 2.0}));
  CHECK(world.at("part").T_world_obj.translation().x() == 0.2);
}

TEST_CASE("bodies and frames on frames of a carrier, and what rests on them, travel with these") {
  World world;
  world.insert(body("tray", {0.0, 0.0, 0.0}));
  world.insert(body("lamp", {0.5, 0.0, 0.0}));
  world.mount("tray", 2, 1, Isometry3d::Identity());
  world.mount("lamp", 2, kFlange, Isometry3d::Identity());
  world.insert(body("cup", {0.0, 0.0, 0.04}));
  world.insert_frame({.name = "probe",
                      .base = FrameBase::kCarrier,
                      .T_on_frame = make_translation({0.0, 0.0, 0.1}),
                      .carrier = 2,
                      .frame = 1});
  world.insert_frame({.name = "tip", .base = FrameBase::kFrame, .on = "probe"});
  CHECK(world.has_mounted(2));
  CHECK_FALSE(world.has_mounted(0));
  CHECK(world.attachment("cup")->mounted);
  CHECK(world.carried_by(2).empty());
  const std::vector<Isometry3d> frames = {Isometry3d::Identity(), make_translation({0.0, 0.3, 0.0}),
                                          make_translation({0.0, 0.0, 0.7})};
  world.move_carried(2, frames);
  CHECK(apart(world, "tray", make_translation({0.0, 0.3, 0.0})) < 1e-15);
  CHECK(apart(world, "cup", make_translation({0.0, 0.3, 0.04})) < 1e-15);
  CHECK(apart(world, "lamp", make_translation({0.5, 0.0, 0.7})) < 1e-15);
  CHECK(world.T_world_frame("tip")->translation().isApprox(Vector3d(0.0, 0.3, 0.1)));
  CHECK(world.mount_of_frame("tip").carrier == 2);
  // A gripper takes the cup from the tray; the tray goes on without it.
  world.attach("cup", 2, frames[2]);
  CHECK(world.carried_by(2) == "cup");
  world.move_carried(2, std::vector<Isometry3d>(3, Isometry3d::Identity()));
  CHECK(apart(world, "cup", make_translation({0.0, 0.3, 0.04 - 0.7})) < 1e-15);
}

TEST_CASE("no body is fastened on itself or on what is fastened on it") {
  World world;
  world.insert(body("a", {0.0, 0.0, 0.0}));
  world.insert(body("b", {0.0, 0.0, 0.1}));
  CHECK_THROWS_AS(world.fasten("a", "a"), ArgumentError);
  world.fasten("b", "a");
  CHECK_THROWS_AS(world.fasten("a", "b"), ArgumentError);
  CHECK_THROWS_AS(world.fasten("b", "c"), ArgumentError);
  CHECK(world.are_fastened("a", "b"));
}
