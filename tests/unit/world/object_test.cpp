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

TEST_CASE("a long body can be taken along its longest side, a rod up to its radius from the end") {
  using Eigen::Vector3d;
  CHECK(grasp_line({.name = "r", .shape = Cylinder{0.015, 0.240}}) == Vector3d(0, 0, 0.105));
  CHECK(grasp_line({.name = "d", .shape = Cylinder{0.05, 0.02}}) == Vector3d::Zero());
  CHECK(grasp_line({.name = "c", .shape = Box{{0.04, 0.04, 0.04}}}) == Vector3d::Zero());
  CHECK(grasp_line({.name = "s", .shape = Sphere{0.1}}) == Vector3d::Zero());
  const Object bar{.name = "b", .shape = Box{{0.02, 0.30, 0.10}}};
  CHECK(grasp_line(bar).isApprox(Vector3d(0.0, 0.1, 0.0), 1e-15));

  Object rod{.name = "r", .shape = Cylinder{0.015, 0.240}};
  rod.T_world_obj.translation() = Vector3d(0.4, 0.1, 0.12);
  CHECK(grasp_distance(rod, {0.4, 0.1, 0.20}) == doctest::Approx(0.0));
  CHECK(grasp_distance(rod, {0.4, 0.103, 0.03}) == doctest::Approx(0.003));
  CHECK(grasp_distance(rod, {0.4, 0.1, 0.235}) == doctest::Approx(0.010));
  rod.p_obj_grasp = Vector3d(0.0, 0.0, 0.120);
  CHECK(grasp_distance(rod, {0.4, 0.1, 0.239}) == doctest::Approx(0.001));
}

TEST_CASE("from above a hand takes the upper end of what stands and the middle of what lies") {
  using Eigen::Vector3d;
  Object rod{.name = "r", .shape = Cylinder{0.015, 0.240}};
  rod.T_world_obj.translation() = Vector3d(0.4, 0.1, 0.12);
  CHECK(grasp_from_above(rod).isApprox(Vector3d(0.4, 0.1, 0.225), 1e-15));
  rod.T_world_obj.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).matrix();
  CHECK(grasp_from_above(rod).isApprox(Vector3d(0.4, 0.1, 0.225), 1e-15));
  for (const double tilt : {0.3, -0.9, 1.2}) {
    rod.T_world_obj.linear() = Eigen::AngleAxisd(tilt, Vector3d::UnitY()).matrix();
    const Vector3d p = grasp_from_above(rod);
    CHECK(grasp_distance(rod, p) < 1e-15);
    CHECK(p.z() == doctest::Approx(0.12 + 0.105 * std::cos(tilt) * std::cos(tilt)));
  }
  rod.T_world_obj.linear() = Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitY()).matrix();
  CHECK(grasp_from_above(rod).isApprox(Vector3d(0.4, 0.1, 0.12), 1e-15));
  rod.T_world_obj.linear().setIdentity();
  rod.p_obj_grasp = Vector3d(0.0, 0.0, -0.05);
  CHECK(grasp_from_above(rod).isApprox(Vector3d(0.4, 0.1, 0.07), 1e-15));
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
