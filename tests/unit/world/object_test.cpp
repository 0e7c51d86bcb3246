#include "armlet/world/object.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"

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
  // 3/80 m (4 r^2 + h^2) about the centre of mass, a quarter of the height above the base.
  const Object cone{.name = "k", .shape = Cone{0.2, 0.4}, .mass = 80.0};
  CHECK(inertia(cone).diagonal().isApprox(Eigen::Vector3d(0.96, 0.96, 0.96), 1e-14));
  CHECK(center_of_mass(cone) == Eigen::Vector3d(0.0, 0.0, -0.1));
  const Object plane{.name = "p", .shape = Plane{{0.3, 0.6}}, .mass = 12.0};
  CHECK(inertia(plane).diagonal().isApprox(Eigen::Vector3d(0.36, 0.09, 0.45), 1e-14));
  CHECK(center_of_mass(plane) == Eigen::Vector3d::Zero());
}

namespace {

// Slices along z, each of them a rectangle or a disc: an inertia that comes from none of the
// formulas for bodies.
struct Slices {
  int count = 4000;
  double low = 0.0, high = 0.0;
  std::function<double(double)> radius{};           // of discs, by z
  Eigen::Vector2d sides = Eigen::Vector2d::Zero();  // of rectangles otherwise

  // Mass 1: the centre's z, and the moments about it.
  [[nodiscard]] std::pair<double, Eigen::Vector3d> integrate() const {
    double mass = 0.0, first = 0.0, second = 0.0;
    Eigen::Vector2d own = Eigen::Vector2d::Zero();
    for (int k = 0; k < count; ++k) {
      const double z = low + (high - low) * (k + 0.5) / count;
      const double r = radius ? radius(z) : 0.0;
      const double area = radius ? r * r * M_PI : sides.prod();
      mass += area;
      first += area * z;
      second += area * z * z;
      own += area * (radius ? Eigen::Vector2d(r * r / 4.0, r * r / 4.0)
                            : Eigen::Vector2d(sides.y() * sides.y(), sides.x() * sides.x()) / 12.0);
    }
    const double z = first / mass, along = second / mass - z * z;
    own /= mass;
    return {z, {own.x() + along, own.y() + along, own.sum()}};
  }
};

}  // namespace

TEST_CASE("inertias and centres of mass are what slices add up to") {
  const auto same = [](const Shape& shape, const Slices& slices) {
    const Object body{.name = "b", .shape = shape, .mass = 1.0};
    const auto [z, moments] = slices.integrate();
    CHECK(center_of_mass(body).z() == doctest::Approx(z).epsilon(1e-6).scale(0.1));
    CHECK(inertia(body).diagonal().isApprox(moments, 1e-6));
  };
  same(Box{{0.03, 0.05, 0.11}}, {.low = -0.055, .high = 0.055, .sides = {0.03, 0.05}});
  same(Cylinder{0.07, 0.2}, {.low = -0.1, .high = 0.1, .radius = [](double) { return 0.07; }});
  same(Sphere{0.3},
       {.low = -0.3, .high = 0.3, .radius = [](double z) { return std::sqrt(0.09 - z * z); }});
  same(Cone{0.07, 0.2},
       {.low = -0.1, .high = 0.1, .radius = [](double z) { return 0.07 * (0.1 - z) / 0.2; }});
  same(Plane{{0.3, 0.2}}, {.count = 1, .sides = {0.3, 0.2}});
}

TEST_CASE("the grasp width is the width along the line on which the fingers close") {
  using Eigen::Vector3d;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  Object box{.name = "b", .shape = Box{{0.05, 0.02, 0.01}}};
  CHECK(grasp_width(box, x) == 0.05);
  CHECK(grasp_width(box, -y) == 0.02);
  CHECK(grasp_width(box, (x + y).normalized()) == doctest::Approx(0.07 / std::sqrt(2.0)));
  box.T_world_obj.linear() = Eigen::AngleAxisd(0.5 * M_PI, z).matrix();
  CHECK(grasp_width(box, x) == doctest::Approx(0.02));
  const Object cylinder{.name = "c", .shape = Cylinder{0.02, 0.03}};
  CHECK(grasp_width(cylinder, x) == 0.04);
  CHECK(grasp_width(cylinder, z) == 0.03);
  CHECK(grasp_width({.name = "s", .shape = Sphere{0.02}}, y) == 0.04);
  const Object plane{.name = "p", .shape = Plane{{0.05, 0.02}}};
  CHECK(grasp_width(plane, x) == 0.05);
  CHECK(grasp_width(plane, z) == 0.0);
}

// The extent of points on the edges, which hold the farthest points of each shape.
TEST_CASE("the grasp width agrees with points on the surface in every direction") {
  using Eigen::Vector3d;
  Random random(12);
  const auto expect = [&](const Shape& shape, const std::vector<Vector3d>& points) {
    for (int round = 0; round < 200; ++round) {
      Object object{.name = "o", .shape = shape};
      const auto part = [&] { return random.uniform(-1.0, 1.0); };
      object.T_world_obj.linear() =
          Eigen::Quaterniond(part(), part(), part(), part()).normalized().toRotationMatrix();
      const Vector3d across = Vector3d(part(), part(), part()).normalized();
      double low = 1.0, high = -1.0;
      for (const Vector3d& p : points) {
        const double at = across.dot(object.T_world_obj.linear() * p);
        low = std::min(low, at);
        high = std::max(high, at);
      }
      CHECK(std::abs(grasp_width(object, across) - (high - low)) < 1e-7);
    }
  };
  const double r = 0.03, h = 0.11;
  std::vector<Vector3d> corners, both_rims, one_rim = {{0.0, 0.0, 0.5 * h}};
  for (const double i : {-0.5, 0.5}) {
    for (const double k : {-0.5, 0.5})
      for (const double m : {-0.5, 0.5}) corners.emplace_back(0.03 * i, 0.12 * k, 0.05 * m);
  }
  for (int k = 0; k < 7200; ++k) {
    const double angle = 2.0 * M_PI * k / 7200;
    const Vector3d out(r * std::cos(angle), r * std::sin(angle), 0.0);
    both_rims.push_back(out + 0.5 * h * Vector3d::UnitZ());
    both_rims.push_back(out - 0.5 * h * Vector3d::UnitZ());
    one_rim.push_back(out - 0.5 * h * Vector3d::UnitZ());
  }
  expect(Box{{0.03, 0.12, 0.05}}, corners);
  expect(Cylinder{r, h}, both_rims);
  expect(Cone{r, h}, one_rim);
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

TEST_CASE("from above a gripper takes the upper end of what stands and the middle of what lies") {
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
  refused([](Object& o) { o.shape = Cone{0.0, 0.1}; });
  refused([](Object& o) { o.shape = Cone{0.1, -0.1}; });
  refused([](Object& o) { o.shape = Plane{{0.1, std::nan("")}}; });
  refused([](Object& o) { o.shape = Sphere{1e-7}; });
  refused([](Object& o) { o.shape = Plane{{0.1, 1.1e4}}; });
  refused([](Object& o) { o.stiffness = 0.0; });
  refused([](Object& o) { o.stiffness = std::numeric_limits<double>::infinity(); });
  refused([](Object& o) { o.T_world_obj.translation()[1] = -1.1e4; });
  refused([](Object& o) { o.mass = -0.1; });
  refused([](Object& o) { o.mass = std::numeric_limits<double>::infinity(); });
  refused([](Object& o) { o.friction = std::nan(""); });
  refused([](Object& o) { o.p_obj_grasp[1] = std::nan(""); });
  refused([](Object& o) { o.T_world_obj.translation()[0] = std::nan(""); });
  refused([](Object& o) { o.T_world_obj.linear() *= 1.1; });
  check_object({.name = "cube", .shape = Box{}});
}
