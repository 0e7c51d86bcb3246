#include "armlet/world/object.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"

using namespace armlet;

// Formulas for a solid of even density: Beer and Johnston, Vector Mechanics for Engineers,
// appendix.
TEST_CASE("inertias are those of solids of even density") {
  const Object box{.name = "b", .shape = Box{{0.1, 0.2, 0.3}}, .mass = 12.0};
  CHECK(inertia(box).diagonal().isApprox(Eigen::Vector3d(0.13, 0.10, 0.05), 1e-14));
  const Object cylinder{.name = "c", .shape = Cylinder{0.1, 0.6}, .mass = 12.0};
  CHECK(inertia(cylinder).diagonal().isApprox(Eigen::Vector3d(0.39, 0.39, 0.06), 1e-14));
  const Object sphere{.name = "s", .shape = Sphere{0.5}, .mass = 10.0};
  CHECK(inertia(sphere).diagonal().isApprox(Eigen::Vector3d(1.0, 1.0, 1.0), 1e-14));
}

TEST_CASE("the grasp width is the smallest width across the approach") {
  const Eigen::Vector3d down(0.0, 0.0, -1.0);
  const Eigen::Vector3d side(1.0, 0.0, 0.0);
  Object box{.name = "b", .shape = Box{{0.05, 0.02, 0.01}}};
  CHECK(grasp_width(box, down) == 0.02);
  CHECK(grasp_width(box, side) == 0.01);
  box.T_world_obj.linear() = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitX()).matrix();
  CHECK(grasp_width(box, down) == 0.01);
  const Object cylinder{.name = "c", .shape = Cylinder{0.02, 0.03}};
  CHECK(grasp_width(cylinder, down) == 0.04);
  CHECK(grasp_width(cylinder, side) == 0.03);
  CHECK(grasp_width({.name = "s", .shape = Sphere{0.02}}, side) == 0.04);
}

TEST_CASE("objects without name, size or a proper pose are refused") {
  const auto refused = [](auto change) {
    Object object{.name = "cube", .shape = Box{}};
    change(object);
    CHECK_THROWS_AS(check_object(object), ArgumentError);
  };
  refused([](Object& o) { o.name.clear(); });
  refused([](Object& o) { o.shape = Box{{0.1, 0.0, 0.1}}; });
  refused([](Object& o) { o.shape = Sphere{-1.0}; });
  refused([](Object& o) { o.shape = Cylinder{0.1, std::nan("")}; });
  refused([](Object& o) { o.mass = -0.1; });
  refused([](Object& o) { o.mass = std::numeric_limits<double>::infinity(); });
  refused([](Object& o) { o.friction = std::nan(""); });
  refused([](Object& o) { o.p_obj_grasp[1] = std::nan(""); });
  refused([](Object& o) { o.T_world_obj.translation()[0] = std::nan(""); });
  refused([](Object& o) { o.T_world_obj.linear() *= 1.1; });
  check_object({.name = "cube", .shape = Box{}});
}
