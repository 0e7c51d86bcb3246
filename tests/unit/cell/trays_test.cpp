// Trays carry what lies on them and towers fall, whatever the bodies are: laws over random scenes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/cell/cell.hpp"
#include "armlet/cell/collisions.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// Bodies that others can rest on, and leaning ones for the top.
Shape random_shape(Random& random, bool flat) {
  const auto size = [&] { return random.uniform(0.03, 0.06); };
  switch (random.below(flat ? 3 : 5)) {
    case 0:
      return Box{{size(), size(), size()}};
    case 1:
      return Cylinder{0.5 * size(), size()};
    case 2:
      return make_mesh(test::box_mesh({size(), size(), size()}));
    case 3:
      return Cone{0.5 * size(), size()};
    default:
      return make_mesh(test::angle_iron());
  }
}

struct TrayScene {
  Cell cell{World(-5.0)};
  std::vector<std::string> names;  // of what is on the tray, from below
};

// A tray in the air, far above the floor, with a tower on it whose top may lean: each let fall onto
// what is below.
void build(TrayScene& scene, Random& random) {
  scene.cell.insert({.name = "tray",
                     .shape = Box{{0.4, 0.4, 0.02}},
                     .T_world_obj = make_translation({0.4, 0.0, 0.01}),
                     .mass = 1.0});
  const int height = 1 + static_cast<int>(random.below(4));
  World scratch = scene.cell.world();
  for (int i = 0; i < height; ++i) {
    const bool top = i + 1 == height;
    Object object{
        .name = "b" + std::to_string(i), .shape = random_shape(random, !top), .mass = 0.1};
    const Vector3d lean(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), 0.0);
    object.T_world_obj =
        pose_from_rpy({0.4 + random.uniform(-0.005, 0.005), random.uniform(-0.005, 0.005), 1.0},
                      {top ? lean.x() : 0.0, top ? lean.y() : 0.0, random.uniform(-3.0, 3.0)});
    scratch.insert(object);
    (void)scratch.drop(object.name);
    scene.names.push_back(object.name);
    scene.cell.insert(scratch.at(object.name));
  }
}

double far_apart(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::vector<Isometry3d> seen_from_tray(const TrayScene& scene) {
  std::vector<Isometry3d> poses;
  for (const std::string& name : scene.names)
    poses.push_back(scene.cell.world().at("tray").T_world_obj.inverse() *
                    scene.cell.world().at(name).T_world_obj);
  return poses;
}

// Every body lies on something, and none in another.
void check_at_rest(const TrayScene& scene) {
  std::vector<std::string> all = scene.names;
  all.emplace_back("tray");
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i]);
    CHECK_FALSE(scene.cell.world().resting_on(all[i]).empty());
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      INFO(all[j]);
      CHECK(distance_between(scene.cell, {.object = all[i]}, {.object = all[j]}) > -1e-5);
    }
  }
}

}  // namespace

TEST_CASE("each body of a tower touches what it rests on, and nothing lies in another") {
  Random random(112);
  for (int round = 0; round < 60; ++round) {
    TrayScene scene;
    build(scene, random);
    std::string below = "tray";
    for (const std::string& name : scene.names) {
      CHECK(std::abs(distance_between(scene.cell, {.object = name}, {.object = below})) < 1e-6);
      CHECK(scene.cell.world().resting_on(name) == below);
      below = name;
    }
    CHECK(scene.cell.world().stacked_on("tray").size() == scene.names.size());
  }
}

TEST_CASE("a tray that is taken, tilted and carried keeps all that is on it, to rounding") {
  Random random(113);
  for (int round = 0; round < 40; ++round) {
    TrayScene scene;
    build(scene, random);
    const int arm = scene.cell.add_robot(make_robot("puma560"), "arm");
    const auto before = seen_from_tray(scene);
    scene.cell.take(arm, "tray");
    for (int step = 0; step < 5; ++step) {
      Eigen::VectorXd q = scene.cell.robot(arm).q;
      for (double& each : q) each += random.uniform(-0.5, 0.5);
      scene.cell.set_joints(arm, q);
      const auto now = seen_from_tray(scene);
      for (std::size_t i = 0; i < now.size(); ++i) CHECK(far_apart(now[i], before[i]) < 1e-13);
    }
    CHECK(scene.cell.robot(arm).loaded->payload().mass ==
          doctest::Approx(1.0 + 0.1 * static_cast<double>(scene.names.size())));
    // Let go, nothing is carried any more.
    (void)scene.cell.let_go(arm);
    for (const std::string& name : scene.names) CHECK_FALSE(scene.cell.world().attachment(name));
    check_at_rest(scene);
  }
}

TEST_CASE(
    "a tower on a tray that is on a robot rides on it; without the tray it falls, from below") {
  Random random(114);
  for (int round = 0; round < 40; ++round) {
    Cell cell(World(0.0));
    const int arm = cell.add_robot(make_robot("scara"), "arm");
    TrayScene model;
    build(model, random);
    cell.insert({.name = "tray", .shape = Box{{0.4, 0.4, 0.02}}, .mass = 1.0},
                {.base = FrameBase::kCarrier, .carrier = arm, .frame = 2});
    const Isometry3d T_tray = cell.world().at("tray").T_world_obj;
    const bool upright = T_tray.linear()(2, 2) > 0.999 || T_tray.linear()(2, 2) < -0.999;
    REQUIRE(upright);
    for (const std::string& name : model.names) {
      Object object = model.cell.world().at(name);
      object.T_world_obj.translation() +=
          T_tray.translation() - model.cell.world().at("tray").T_world_obj.translation();
      cell.insert(object);
      CHECK(cell.world().attachment(name)->mounted);
    }
    const Isometry3d T_top = T_tray.inverse() * cell.world().at(model.names.back()).T_world_obj;
    Eigen::VectorXd q = cell.robot(arm).q;
    q[0] += random.uniform(-1.0, 1.0);
    q[1] += random.uniform(-1.0, 1.0);
    cell.set_joints(arm, q);
    CHECK(far_apart(cell.world().at("tray").T_world_obj.inverse() *
                        cell.world().at(model.names.back()).T_world_obj,
                    T_top) < 1e-13);
    const auto falls = cell.remove("tray");
    CHECK(falls.size() == model.names.size());
    CHECK(cell.world().resting_on(model.names.front()) == "floor");
    for (std::size_t i = 0; i < model.names.size(); ++i)
      CHECK_FALSE(cell.world().attachment(model.names[i]));
  }
}

TEST_CASE("the same scene falls to the same bits") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Random first(seed), second(seed);
    TrayScene a, b;
    build(a, first);
    build(b, second);
    for (const std::string& name : a.names)
      CHECK(a.cell.world().at(name).T_world_obj.matrix() ==
            b.cell.world().at(name).T_world_obj.matrix());
  }
}
