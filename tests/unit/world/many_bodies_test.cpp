// Worlds of many bodies: what the grids and lists find is what a search through all bodies finds.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/world/world.hpp"
#include "world/support.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

Object box_at(std::string name, const Vector3d& size, const Vector3d& p) {
  Object object{.name = std::move(name), .shape = Box{size}};
  object.T_world_obj = make_translation(p);
  return object;
}

// Boxes along the axes: one lies on another if their rectangles overlap and the faces meet.
bool lies_on(const Object& upper, const Object& lower) {
  const Vector3d a = std::get<Box>(upper.shape).size, b = std::get<Box>(lower.shape).size;
  const Vector3d apart = upper.T_world_obj.translation() - lower.T_world_obj.translation();
  const bool above = std::abs(apart.x()) < 0.5 * (a.x() + b.x()) - 1e-6 &&
                     std::abs(apart.y()) < 0.5 * (a.y() + b.y()) - 1e-6;
  return above && !upper.fixed && std::abs(apart.z() - 0.5 * (a.z() + b.z())) <= kRestTolerance;
}

std::vector<std::string> all_above(const World& world, const std::string& name) {
  std::set<std::string> found{name};
  for (bool grows = true; grows;) {
    grows = false;
    for (const std::string& upper : world.names()) {
      for (const std::string& lower : std::set<std::string>(found))
        grows = (lies_on(world.at(upper), world.at(lower)) && found.insert(upper).second) || grows;
    }
  }
  std::vector<std::string> above;
  for (const std::string& each : world.names()) {
    if (each != name && found.contains(each)) above.push_back(each);
  }
  return above;
}

Vector3d some(Random& random, double least, double most) {
  return {random.uniform(least, most), random.uniform(least, most), random.uniform(least, most)};
}

}  // namespace

TEST_CASE("of boxes dropped at random positions all rest, and stacks are what a search finds") {
  Random random(31);
  for (int round = 0; round < 12; ++round) {
    World world(0.0);
    // Tables of a metre and dice of a centimetre.
    for (int i = 0; i < 60; ++i) {
      const Vector3d size = i % 10 == 0 ? Vector3d(1.0, 0.8, 0.05) : some(random, 0.01, 0.12);
      const Vector3d p(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 3.0);
      const std::string name = "box" + std::to_string(i);
      world.insert(box_at(name, size, p));
      const Drop drop = world.drop(name);
      CHECK(world.resting_on(name) == drop.support);
    }
    for (int i = 0; i < 30; ++i) {
      const std::vector<std::string> names = world.names();
      const std::string name = names[static_cast<std::size_t>(random.below(names.size()))];
      CHECK(world.stacked_on(name) == all_above(world, name));
      if (i % 2 == 0) {
        world.remove(name);
        CHECK(world.find(name) == nullptr);
      } else {
        const Vector3d p(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 3.0);
        world.set_pose(name, make_translation(p));
        world.drop(name);
      }
      // Nothing hangs in the air, and nothing lies in anything else.
      for (const std::string& each : world.names()) {
        CHECK_FALSE(world.resting_on(each).empty());
        for (const std::string& other : world.names()) {
          if (other == each) continue;
          const Vector3d a = std::get<Box>(world.at(each).shape).size;
          const Vector3d b = std::get<Box>(world.at(other).shape).size;
          const Vector3d apart =
              (world.at(each).T_world_obj.translation() - world.at(other).T_world_obj.translation())
                  .cwiseAbs();
          CHECK((apart - 0.5 * (a + b)).maxCoeff() > -kRestTolerance);
        }
      }
    }
  }
}

TEST_CASE("bodies near a ball are found wherever they were put, carried or fastened") {
  Random random(32);
  World world;
  for (int i = 0; i < 400; ++i) {
    const std::string name = "ball" + std::to_string(i);
    Object ball{.name = name, .shape = Sphere{std::pow(10.0, random.uniform(-3.0, 0.0))}};
    ball.T_world_obj = make_translation(some(random, -3.0, 3.0));
    ball.fixed = true;
    world.insert(ball);
    if (i % 7 == 1) world.fasten(name, "ball" + std::to_string(i - 1));
    if (i % 11 == 5) world.mount(name, 2, kFlange, Eigen::Isometry3d::Identity());
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (int round = 0; round < 300; ++round) {
    const std::vector<std::string> names = world.names();
    const std::string name = names[static_cast<std::size_t>(random.below(names.size()))];
    if (round % 3 == 0) world.set_pose(name, make_translation(some(random, -3.0, 3.0)));
    if (round % 3 == 1) world.remove(name);
    T.translation() = some(random, -1.0, 1.0);
    world.move_carried(2, T);
    const Vector3d middle = some(random, -3.0, 3.0);
    const double radius = random.uniform(0.0, 1.0);
    std::vector<std::size_t> expected, carried;
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Object& each = world.object(i);
      REQUIRE(world.find(each.name) == &each);
      const double apart = (each.T_world_obj.translation() - middle).norm();
      if (apart <= radius + std::get<Sphere>(each.shape).radius) expected.push_back(i);
      if (world.attachment_of(i)) carried.push_back(i);
      const std::string& on = world.fastened_on(i);
      REQUIRE((on.empty() || world.find(on) != nullptr));
      const std::vector<std::string> with = world.fastened_with(each.name);
      CHECK((std::ranges::find(with, each.name) != with.end()) == !on.empty());
      if (!on.empty()) CHECK(world.are_fastened(each.name, on));
    }
    CHECK(world.near(middle, radius) == expected);
    CHECK(world.carried() == carried);
  }
}

TEST_CASE("a copy of a world is a world of its own") {
  World world(0.0);
  world.insert(box_at("low", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.05}));
  world.insert(box_at("high", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.15}));
  World copy = world;
  copy.remove("low");
  CHECK(copy.at("high").T_world_obj.translation().z() == doctest::Approx(0.05));
  CHECK(world.at("high").T_world_obj.translation().z() == doctest::Approx(0.15));
  CHECK(world.stacked_on("low") == std::vector<std::string>{"high"});
}

// All that can be reached along these edges, without the start.
static std::set<std::size_t> reached_from(std::size_t start,
                                          const std::vector<std::vector<std::size_t>>& edges) {
  std::set<std::size_t> found{start};
  std::vector<std::size_t> open{start};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t next : edges[at]) {
      if (found.insert(next).second) open.push_back(next);
    }
  }
  found.erase(start);
  return found;
}

// What rests on what by resting_height of all pairs, which leaves out no body.
TEST_CASE("of bodies of all shapes that lie deep in one another the right ones carry") {
  Random random(33);
  const auto shape = [&]() -> Shape {
    const auto size = [&] { return random.uniform(0.005, 0.2); };
    switch (random.below(4)) {
      case 0:
        return Sphere{size()};
      case 1:
        return Cylinder{size(), size()};
      case 2:
        return Plane{{size(), size()}};
      default:
        return Box{{size(), size(), size()}};
    }
  };
  int resting = 0;
  std::size_t stacked = 0;
  for (int round = 0; round < 20; ++round) {
    World world(0.0);
    for (int i = 0; i < 80; ++i) {
      Object object{.name = "body" + std::to_string(i), .shape = shape()};
      object.T_world_obj = make_translation(some(random, 0.0, 0.1) + Vector3d(0.0, 0.0, 0.3));
      world.insert(object);
      if (i % 3 == 0) world.drop(object.name);
    }
    const std::vector<std::string> names = world.names();
    std::vector<std::vector<std::size_t>> carries(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Object& upper = world.at(names[i]);
      const double z = upper.T_world_obj.translation().z();
      double least = z - half_height(upper);
      if (least < -kRestTolerance) least = INFINITY;  // it is in the floor
      for (std::size_t k = 0; k < names.size(); ++k) {
        const auto rest = i == k ? std::nullopt : resting_height(upper, world.at(names[k]));
        const double gap = rest ? z - *rest : -INFINITY;
        if (std::abs(gap) <= kRestTolerance) carries[k].push_back(i);
        if (gap >= -kRestTolerance) least = std::min(least, gap);
      }
      CHECK(world.resting_on(names[i]).empty() == !(std::abs(least) <= kRestTolerance));
      resting += world.resting_on(names[i]).empty() ? 0 : 1;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      std::vector<std::string> expected;
      for (const std::size_t each : reached_from(i, carries)) expected.push_back(names[each]);
      CHECK(world.stacked_on(names[i]) == expected);
      stacked += expected.size();
    }
  }
  CHECK(stacked > 1000);
  CHECK(resting > 300);
}
