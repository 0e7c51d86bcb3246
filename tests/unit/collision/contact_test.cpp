#include "armlet/collision/contact.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Solid at(Shape shape, const Vector3d& p, const Vector3d& rpy = Vector3d::Zero()) {
  Solid solid = solid_of(shape);
  solid.T = pose_from_rpy(p, rpy);
  return solid;
}

Shape random_shape(Random& random) {
  const auto size = [&] { return random.uniform(0.01, 0.2); };
  switch (random.below(5)) {
    case 0:
      return Box{{size(), size(), size()}};
    case 1:
      return Cylinder{size(), size()};
    case 2:
      return Cone{size(), size()};
    case 3:
      return Plane{{size(), size()}};
    default:
      return Sphere{size()};
  }
}

Solid random_solid(Random& random, double spread) {
  const auto within = [&](double most) { return random.uniform(-most, most); };
  return at(random_shape(random), {within(spread), within(spread), within(spread)},
            {within(3.0), within(1.5), within(3.0)});
}

}  // namespace

TEST_CASE("the depth along a normal frees the bodies, and less does not") {
  Random random(75);
  int deep = 0;
  for (int i = 0; i < 20000; ++i) {
    Solid a = random_solid(random, 0.1);
    const Solid b = random_solid(random, 0.1);
    const Vector3d n = Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                random.uniform(-1.0, 1.0) + 1e-3)
                           .normalized();
    const double depth = depth_along(a, b, n);
    REQUIRE(depth >= 0.0);
    const Gap gap = gap_between(a, b);
    if (gap.distance > 0.0) {
      // Apart: nothing to free along n, unless moving along it passes through the other one.
      continue;
    }
    ++deep;
    CHECK(depth >= -gap.distance - 2e-7);
    const Vector3d p = a.T.translation();
    a.T.translation() = p + depth * n;
    // Gaps are known to 1e-9 m, and overlaps are reported too deep by up to 1e-7 m, and of their
    // size.
    const double left = gap_between(a, b).distance;
    CHECK(left < 1e-8);
    CHECK(left > -3e-7);
    a.T.translation() = p + (depth + 1e-5) * n;
    CHECK(gap_between(a, b).distance >= 0.0);
    if (depth < 1e-4) continue;
    a.T.translation() = p + (depth - 5e-5) * n;
    CHECK_FALSE(is_farther(a, b, 0.0));
  }
  CHECK(deep > 5000);
}

TEST_CASE("normals of faces are exact, those of round bodies lead from centre to centre") {
  Random random(76);
  for (int i = 0; i < 500; ++i) {
    const Vector3d rpy(random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5),
                       random.uniform(-3.0, 3.0));
    const Solid table = at(Box{{0.4, 0.3, 0.1}}, {0.1, 0.2, 0.3}, rpy);
    const Vector3d up = table.T.linear().col(2);
    const double off = random.uniform(-5e-6, 1e-5);
    // A ball, a can standing on the face, a cone standing on its tip and on its base.
    for (const Solid& body :
         {at(Sphere{0.02}, table.T * Vector3d(0.1, -0.1, 0.07 + off)),
          at(Cylinder{0.02, 0.06}, table.T * Vector3d(0.05, 0.1, 0.08 + off), rpy),
          at(Cone{0.02, 0.06}, table.T * Vector3d(0.05, 0.1, 0.08 + off), rpy)}) {
      CHECK((contact_normal(body, table) - up).norm() < 1e-12);
      CHECK((contact_normal(table, body) + up).norm() < 1e-12);
    }
    Solid tip = at(Cone{0.02, 0.06}, table.T * Vector3d(0.05, 0.1, 0.08 + off), rpy);
    tip.T.linear() = tip.T.linear() * Eigen::AngleAxisd(M_PI, Vector3d::UnitX());
    CHECK((contact_normal(tip, table) - up).norm() < 1e-12);
    const Vector3d side = table.T.linear() * Vector3d(0.6, 0.0, 0.8);
    const Solid one = at(Sphere{0.03}, {0.1, 0.0, 0.0});
    const Solid other = at(Sphere{0.05}, one.T.translation() + (0.08 + off) * side);
    CHECK((contact_normal(other, one) - side).norm() < 1e-12);
  }
}

TEST_CASE("pressure is in the middle of what both faces have in common") {
  const Vector3d up = Vector3d::UnitZ();
  const Solid table = at(Box{{0.4, 0.4, 0.1}}, {0.0, 0.0, -0.05});
  const auto middle = [&](const Solid& body, const Solid& on) {
    return pressure_point(body, on, up);
  };
  const auto is = [](const Vector3d& p, const Vector3d& q) { return (p - q).norm() < 1e-10; };
  CHECK(is(middle(at(Box{{0.1, 0.06, 0.04}}, {0.05, 0.0, 0.019}), table), {0.05, 0.0, -0.001}));
  CHECK(is(middle(at(Cylinder{0.03, 0.04}, {0.1, 0.1, 0.019}), table), {0.1, 0.1, -0.001}));
  CHECK(is(middle(at(Cone{0.03, 0.04}, {0.1, 0.1, 0.019}), table), {0.1, 0.1, -0.001}));
  CHECK(is(middle(at(Sphere{0.03}, {0.1, 0.1, 0.029}), table), {0.1, 0.1, -0.001}));
  // Half over the edge: a quarter of the side inwards. A lying can along its line of contact.
  CHECK(is(middle(at(Box{{0.08, 0.06, 0.04}}, {0.2, 0.0, 0.02}), table), {0.18, 0.0, 0.0}));
  CHECK(is(middle(at(Cylinder{0.03, 0.1}, {0.2, 0.0, 0.03}, {0.0, M_PI / 2, 0.0}), table),
           {0.175, 0.0, 0.0}));
  // A plate on a post, a plate on a ball, a box that stands on one edge.
  CHECK(is(middle(at(Box{{0.4, 0.4, 0.02}}, {0.1, 0.0, 0.01}),
                  at(Cylinder{0.01, 0.1}, {0.0, 0.0, -0.05})),
           {0.0, 0.0, 0.0}));
  CHECK(
      is(middle(at(Box{{0.4, 0.4, 0.02}}, {0.1, 0.0, 0.01}), at(Sphere{0.05}, {0.02, 0.03, -0.05})),
         {0.02, 0.03, 0.0}));
  const Solid leaning = at(Box{{0.1, 0.06, 0.04}}, {0.0, 0.0, 0.03}, {0.3, 0.0, 0.0});
  const Vector3d edge = leaning.T * Vector3d(0.0, -0.03, -0.02);
  CHECK(is(middle(leaning, table), edge));
  // Two beams that cross.
  CHECK(is(middle(at(Cylinder{0.01, 0.4}, {0.0, 0.05, 0.01}, {0.0, M_PI / 2, 0.0}),
                  at(Cylinder{0.01, 0.4}, {0.03, 0.0, -0.01}, {M_PI / 2, 0.0, 0.0})),
           {0.03, 0.05, 0.0}));
  // Two discs that share a lens: half way between their centres, by symmetry.
  const Vector3d lens = middle(at(Cylinder{0.05, 0.02}, {0.04, 0.0, 0.01}),
                               at(Cylinder{0.05, 0.02}, {0.0, 0.0, -0.01}));
  CHECK((lens - Vector3d(0.02, 0.0, 0.0)).norm() < 1e-5);
}

}  // namespace armlet
