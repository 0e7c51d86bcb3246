// Where bodies rest: against numbers by hand, and against stepping down in small steps.
#include "armlet/collision/resting.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/collision/solid.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

Object body(Shape shape, const Vector3d& p, const Vector3d& rpy = Vector3d::Zero()) {
  return {.name = "body", .shape = std::move(shape), .T_world_obj = pose_from_rpy(p, rpy)};
}

double z(const std::optional<double>& height) { return height.value_or(std::nan("")); }

bool is_free(const Object& upper, double height, const Object& lower) {
  Solid a = solid_of(upper.shape), b = solid_of(lower.shape);
  a.T = upper.T_world_obj;
  a.T.translation().z() = height;
  b.T = lower.T_world_obj;
  return is_farther(a, b, 0.0);
}

}  // namespace

TEST_CASE("bodies that lean rest on their shapes") {
  const double edge = 0.02 * std::sqrt(2.0);
  const Object table = body(Box{{0.4, 0.4, 0.02}}, {0.0, 0.0, 0.0});
  const Object wedge = body(Box{{0.04, 0.04, 0.04}}, {0.0, 0.0, 0.5}, {0.0, M_PI / 4, 0.0});
  CHECK(z(resting_height_of_shapes(wedge, table)) == doctest::Approx(0.01 + edge).epsilon(1e-7));
  // A ball beside the edge of the wedge: on its inclined face, r sqrt(2) above it.
  const Object ball = body(Sphere{0.01}, {0.012, 0.0, 0.5});
  const Object low_wedge = body(Box{{0.04, 0.04, 0.04}}, {0.0, 0.0, 0.0}, {0.0, M_PI / 4, 0.0});
  CHECK(z(resting_height_of_shapes(ball, low_wedge)) ==
        doctest::Approx(edge - 0.012 + 0.01 * std::sqrt(2.0)).epsilon(1e-7));
  // A lying cylinder on a lying cylinder across, side by side in height by both radii.
  const Object lower = body(Cylinder{0.02, 0.2}, {0.0, 0.0, 0.0}, {M_PI / 2, 0.0, 0.0});
  const Object upper = body(Cylinder{0.01, 0.2}, {0.0, 0.0, 0.5}, {0.0, M_PI / 2, 0.0});
  CHECK(z(resting_height_of_shapes(upper, lower)) == doctest::Approx(0.03).epsilon(1e-7));
  // Parallel, 0.018 aside: on the round, 0.03 apart.
  const Object along = body(Cylinder{0.01, 0.2}, {0.018, 0.0, 0.5}, {M_PI / 2, 0.0, 0.0});
  CHECK(z(resting_height_of_shapes(along, lower)) == doctest::Approx(0.024).epsilon(1e-7));
  // A cone on its tip carries a plate there, and a ball passes its side.
  const Object cone = body(Cone{0.05, 0.1}, {0.0, 0.0, 0.0});
  const Object plate = body(Box{{0.02, 0.02, 0.01}}, {0.0, 0.0, 0.5});
  CHECK(z(resting_height_of_shapes(plate, cone)) == doctest::Approx(0.055).epsilon(1e-7));
  CHECK_FALSE(resting_height_of_shapes(body(Sphere{0.01}, {0.0601, 0.0, 0.5}), cone));
}

TEST_CASE("side by side, bodies that overlap by less than a micrometre pass each other") {
  const Object post = body(Box{{0.04, 0.04, 0.2}}, {0.0, 0.0, 0.0}, {0.0, 1e-4, 0.0});
  const double half = 0.02 * std::cos(1e-4) + 0.1 * std::sin(1e-4);
  const auto beside = [&](double overlap) {
    return resting_height_of_shapes(
        body(Box{{0.04, 0.04, 0.04}}, {half + 0.02 - overlap, 0.0, 0.5}), post);
  };
  CHECK_FALSE(beside(0.0));
  CHECK_FALSE(beside(2e-7));
  CHECK(beside(1e-4));
}

TEST_CASE("things rest on the triangles of a mesh: in its hollow, not on the box around it") {
  // Two legs 100 mm long, 20 mm thick, 50 mm high; three quarters of the box around it are free.
  const TriangleMesh iron = test::angle_iron();
  const Object angle = body(make_mesh(iron), {0.0, 0.0, 0.025});
  CHECK_FALSE(resting_height_of_shapes(body(Sphere{0.01}, {0.02, 0.02, 0.5}), angle));
  CHECK(z(resting_height_of_shapes(body(Sphere{0.005}, {0.02, -0.04, 0.5}), angle)) ==
        doctest::Approx(0.055).epsilon(1e-7));
  // And the mesh on things, likewise: with its hollow it passes a post.
  const Object post = body(Cylinder{0.005, 0.02}, {0.02, 0.02, 0.0});
  CHECK_FALSE(resting_height_of_shapes(body(make_mesh(iron), {0.0, 0.0, 0.5}), post));
}

TEST_CASE("the roof of a mesh carries what is above it, not what is below") {
  // One leg stands, the other one is a roof from x = -0.03 to 0.05 at z from 0.03 to 0.05.
  const Object shelter =
      body(make_mesh(test::angle_iron()), {0.0, 0.0, 0.0}, {-M_PI / 2, 0.0, 0.0});
  const double roof = 0.05;
  CHECK(z(resting_height_of_shapes(body(Sphere{0.01}, {0.02, 0.0, 0.5}), shelter)) ==
        doctest::Approx(roof + 0.01).epsilon(1e-7));
  CHECK_FALSE(resting_height_of_shapes(body(Sphere{0.01}, {0.02, 0.0, 0.0}), shelter));
}

TEST_CASE("the height is the first at which the bodies meet, for random shapes and positions") {
  Random random(111);
  const auto number = [&](double low, double high) { return random.uniform(low, high); };
  const auto shape = [&]() -> Shape {
    switch (random.below(5)) {
      case 0:
        return Box{{number(0.02, 0.1), number(0.02, 0.1), number(0.02, 0.1)}};
      case 1:
        return Cylinder{number(0.01, 0.05), number(0.02, 0.1)};
      case 2:
        return Cone{number(0.01, 0.05), number(0.02, 0.1)};
      case 3:
        return Sphere{number(0.01, 0.05)};
      default:
        return make_mesh(test::angle_iron());
    }
  };
  const auto turned = [&] { return Vector3d(number(-3, 3), number(-1.5, 1.5), number(-3, 3)); };
  int rested = 0;
  for (int round = 0; round < 400; ++round) {
    const Object lower = body(shape(), Vector3d::Zero(), turned());
    const Object upper = body(shape(), {number(-0.08, 0.08), number(-0.08, 0.08), 0.5}, turned());
    const auto height = resting_height_of_shapes(upper, lower);
    constexpr double kStep = 5e-4;
    double at = 0.5;
    while (at > -0.5 && is_free(upper, at, lower)) at -= kStep;
    if (!height) {
      // Steps see what touches by less than a micrometre from the side.
      if (at > -0.5) CHECK(is_free(body(upper.shape, upper.T_world_obj.translation()), 9.0, lower));
      continue;
    }
    ++rested;
    CHECK(*height > at - 1e-6);
    CHECK(*height < at + kStep + 1e-6);
    CHECK(is_free(upper, *height + 1e-6, lower));
  }
  CHECK(rested > 100);
}
