#include "armlet/collision/solid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/math/rotation.hpp"
#include "random_pose.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Core = Solid::Core;

constexpr Core kCores[] = {Core::kPoint, Core::kSegment, Core::kBox, Core::kCylinder, Core::kCone};

Solid random_solid(Random& random, Core core, double spread) {
  const auto size = [&] { return random.below(6) == 0 ? 0.0005 : random.uniform(0.005, 0.2); };
  Solid solid{.core = core, .T = random_pose(random, spread)};
  const double r = size();
  switch (core) {
    case Core::kPoint:
      solid.margin = r;
      break;
    case Core::kSegment:
      solid.half = {0.0, 0.0, size()};
      solid.margin = r;
      break;
    case Core::kBox:
      solid.half = {size(), size(), size()};
      break;
    case Core::kCylinder:
    case Core::kCone:
      solid.half = {r, r, size()};
      break;
    default:  // meshes: mesh_gap_test.cpp
      break;
  }
  return solid;
}

// How far a body reaches along a direction, written down independently of its support points.
double extent(const Solid& solid, const Vector3d& direction) {
  const Vector3d d = solid.T.linear().transpose() * direction;
  const double across = std::hypot(d.x(), d.y());
  double reach = solid.T.translation().dot(direction) + solid.margin * direction.norm();
  switch (solid.core) {
    case Core::kPoint:
    case Core::kSegment:
    case Core::kBox:
      return reach + d.cwiseAbs().dot(solid.half);
    case Core::kCylinder:
      return reach + across * solid.half.x() + std::abs(d.z()) * solid.half.z();
    case Core::kCone:
      return reach +
             std::max(d.z() * solid.half.z(), across * solid.half.x() - d.z() * solid.half.z());
    default:
      break;
  }
  return reach;
}

// Distance of a point from the core, zero inside, for what is outside of it by rounding only.
double outside(const Solid& solid, const Vector3d& p_world) {
  const Vector3d p = solid.T.inverse() * p_world;
  const Vector3d& half = solid.half;
  const double across = std::hypot(p.x(), p.y());
  switch (solid.core) {
    case Core::kPoint:
    case Core::kSegment:
    case Core::kBox:
      return (p.cwiseAbs() - half).cwiseMax(0.0).norm() - solid.margin;
    case Core::kCylinder:
      return std::max({across - half.x(), std::abs(p.z()) - half.z(), 0.0});
    case Core::kCone: {
      const double slope = std::hypot(half.x(), 2.0 * half.z());
      const double side = (2.0 * half.z() * across + half.x() * (p.z() - half.z())) / slope;
      return std::max({side, -half.z() - p.z(), 0.0});
    }
    default:
      break;
  }
  return 0.0;
}

// How far `a` lies on its side of the widest slab across `direction` that is between both.
double separation(const Solid& a, const Solid& b, const Vector3d& away) {
  return -extent(a, -away) - extent(b, away);
}

// Two segments (Ericson 2005, section 5.1.9), as ALGORITHMS of the project give it.
double segment_distance(const Vector3d& p1, const Vector3d& q1, const Vector3d& p2,
                        const Vector3d& q2) {
  const Vector3d d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = d1.dot(d1), e = d2.dot(d2), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const double den = a * e - b * b;
  double s = den > 1e-12 * a * e ? std::clamp((b * f - c * e) / den, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((t * b - c) / a, 0.0, 1.0);
  }
  return (p1 + s * d1 - p2 - t * d2).norm();
}

// Overlap of two boxes along their 15 axes: the least is how far one has to be moved.
double box_depth(const Solid& a, const Solid& b) {
  std::vector<Vector3d> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(a.T.linear().col(i));
    axes.push_back(b.T.linear().col(i));
    for (int j = 0; j < 3; ++j) {
      const Vector3d cross = a.T.linear().col(i).cross(b.T.linear().col(j));
      if (cross.norm() > 1e-9) axes.push_back(cross.normalized());
    }
  }
  double best = -std::numeric_limits<double>::infinity();
  for (const Vector3d& axis : axes)
    best = std::max({best, separation(a, b, axis), separation(a, b, -axis)});
  return -best;
}

// The least depth over many directions, each followed downhill.
double searched_depth(const Solid& a, const Solid& b, Random& random) {
  double least = std::numeric_limits<double>::infinity();
  for (int start = 0; start < 400; ++start) {
    Vector3d n = (random_vector(random, 1.0) + Vector3d(1e-6, 0.0, 0.0)).normalized();
    double depth = -separation(a, b, n);
    for (double step = 0.3; step > 1e-7;) {
      const Vector3d tried = (n + step * random_vector(random, 1.0)).normalized();
      const double there = -separation(a, b, tried);
      if (there < depth) {
        n = tried;
        depth = there;
      } else {
        step *= 0.8;
      }
    }
    least = std::min(least, depth);
  }
  return least;
}

struct Segment3d {
  Vector3d p, q;
};
Segment3d axis_of(const Solid& capsule) {
  return {capsule.T * Vector3d(0.0, 0.0, -capsule.half.z()),
          capsule.T * Vector3d(0.0, 0.0, capsule.half.z())};
}

}  // namespace

// Duality proves each case by itself: points of both bodies are that far apart, and a slab of that
// width is between the bodies.
TEST_CASE("the distance of bodies that are apart is proved by two points and a slab") {
  Random random(1);
  int apart = 0;
  for (int round = 0; round < 2000; ++round) {
    for (const Core core_a : kCores) {
      for (const Core core_b : kCores) {
        const Solid a = random_solid(random, core_a, 0.3), b = random_solid(random, core_b, 0.3);
        const Gap gap = gap_between(a, b);
        if (gap.distance < 1e-6) continue;
        ++apart;
        REQUIRE(outside(a, gap.p_a) < 1e-9);
        REQUIRE(outside(b, gap.p_b) < 1e-9);
        REQUIRE((gap.p_a - gap.p_b).norm() == doctest::Approx(gap.distance).epsilon(1e-9));
        REQUIRE(std::abs(separation(a, b, gap.away) - gap.distance) < 2e-9);
        REQUIRE(is_farther(a, b, gap.distance - 1e-8));
        REQUIRE_FALSE(is_farther(a, b, gap.distance + 1e-12));
      }
    }
  }
  CHECK(apart > 30000);
}

TEST_CASE("overlapping bodies: the depth frees them, and there is no shorter one") {
  Random random(2);
  int overlapping = 0;
  for (int round = 0; round < 30; ++round) {
    for (const Core core_a : kCores) {
      for (const Core core_b : kCores) {
        const Solid a = random_solid(random, core_a, 0.05), b = random_solid(random, core_b, 0.05);
        const Gap gap = gap_between(a, b);
        if (gap.distance > -1e-6) continue;
        ++overlapping;
        REQUIRE(std::abs(gap.away.norm() - 1.0) < 1e-12);
        Solid freed = a;
        freed.T.translation() += (1e-9 - gap.distance) * gap.away;
        REQUIRE(gap_between(freed, b).distance > -1e-9);
        REQUIRE(-gap.distance <= searched_depth(a, b, random) + 2e-7);
      }
    }
  }
  CHECK(overlapping > 300);
}

// Random poses of boxes, thin ones and cylinders, where many triangles of a difference lie in one
// plane. Half of them are not rotated against each other, so that whole faces are parallel.
TEST_CASE("the points of overlapping bodies are the pair of deepest penetration") {
  Random random(9);
  int overlapping = 0;
  for (int round = 0; round < 6000; ++round) {
    const auto body = [&] {
      Solid solid = random_solid(random, round % 3 == 2 ? Core::kCylinder : Core::kBox, 0.05);
      if (round % 3 == 1) solid.half[static_cast<int>(random.below(3))] = 0.0;
      return solid;
    };
    const Solid a = body();
    Solid b = round % 6 < 3 ? body() : random_solid(random, Core::kBox, 0.05);
    if (round % 2 == 0) b.T.linear() = a.T.linear();
    const Gap gap = gap_between(a, b);
    if (gap.distance > -1e-6) continue;
    ++overlapping;
    const Vector3d free = gap.p_b - gap.p_a;
    REQUIRE(std::abs(free.norm() + gap.distance) < 1e-12);
    REQUIRE(outside(a, gap.p_a) < 1e-9);
    REQUIRE(outside(b, gap.p_b) < 1e-6);
    Solid freed = a;
    freed.T.translation() += free + 1e-9 * gap.away;
    REQUIRE(gap_between(freed, b).distance > -1e-9);
    REQUIRE(separation(freed, b, gap.away) > -1e-9);
    if (a.core == Core::kBox && b.core == Core::kBox)
      REQUIRE(std::abs(gap.distance + box_depth(a, b)) < 1e-7);
  }
  CHECK(overlapping > 2000);
}

TEST_CASE("capsules agree with the distance of segments") {
  Random random(3);
  for (int round = 0; round < 20000; ++round) {
    const Solid a = random_solid(random, Core::kSegment, 0.3);
    const Solid b = random_solid(random, Core::kSegment, 0.3);
    const auto [p1, q1] = axis_of(a);
    const auto [p2, q2] = axis_of(b);
    const double exact = segment_distance(p1, q1, p2, q2) - a.margin - b.margin;
    REQUIRE(std::abs(gap_between(a, b).distance - exact) < 1e-9);
  }
}

TEST_CASE("boxes agree with their separating axes") {
  Random random(4);
  int overlapping = 0;
  for (int round = 0; round < 20000; ++round) {
    const Solid a = random_solid(random, Core::kBox, 0.1);
    const Solid b = random_solid(random, Core::kBox, 0.1);
    const double depth = box_depth(a, b);
    const Gap gap = gap_between(a, b);
    if (depth > 1e-9) {
      ++overlapping;
      REQUIRE(std::abs(gap.distance + depth) < 1e-7);
    } else if (depth < -1e-9) {
      REQUIRE(gap.distance >= -depth - 1e-9);
    }
  }
  CHECK(overlapping > 5000);
}

TEST_CASE("bodies face to face touch") {
  const Solid table = solid_of(Shape(Box{{0.8, 0.6, 0.1}}));
  for (const Shape& shape :
       {Shape(Box{{0.04, 0.04, 0.04}}), Shape(Cylinder{0.02, 0.04}), Shape(Sphere{0.02})}) {
    Solid body = solid_of(shape);
    for (const double x : {0.0, 0.1, 0.38, 0.4}) {
      body.T.translation() = Vector3d(x, 0.05, 0.07);
      CHECK(std::abs(gap_between(body, table).distance) < 1e-9);
      CHECK(std::abs(gap_between(table, body).distance) < 1e-9);
      body.T.translation().z() = 0.07 - 1e-4;
      const Gap sunk = gap_between(body, table);
      CHECK(sunk.distance == doctest::Approx(-1e-4).epsilon(1e-3));
      CHECK(sunk.away.z() == doctest::Approx(1.0));
    }
  }
}

TEST_CASE("the same body twice, bodies in one position, huge coordinates") {
  for (const Core core : kCores) {
    Random random(5);
    Solid a = random_solid(random, core, 0.0);
    const Gap same = gap_between(a, a);
    CHECK(same.distance < 0.0);
    CHECK(same.distance >= -2.0 * a.reach());
    Solid far = a;
    far.T.translation().x() += 1e9;
    CHECK(gap_between(a, far).distance == doctest::Approx(1e9));
    a.T.translation().x() += 1e9;
    CHECK(gap_between(a, far).distance < 1e-6);
  }
}

TEST_CASE("distances worked out by hand") {
  Solid box = solid_of(Shape(Box{{0.2, 0.2, 0.2}}));
  Solid ball = solid_of(Shape(Sphere{0.05}));
  ball.T.translation() = Vector3d(0.2, 0.2, 0.0);
  CHECK(gap_between(box, ball).distance == doctest::Approx(0.1 * std::sqrt(2.0) - 0.05));
  ball.T.translation() = Vector3d(0.08, 0.0, 0.0);
  CHECK(gap_between(box, ball).distance == doctest::Approx(-0.02 - 0.05));
  Solid cone{.core = Core::kCone, .half = {0.03, 0.03, 0.05}};
  cone.T.translation() = Vector3d(0.0, 0.0, 0.25);
  CHECK(gap_between(cone, box).distance == doctest::Approx(0.1));
  cone.T.linear() = rot_x(std::numbers::pi);
  cone.T.translation() = Vector3d(0.0, 0.0, 0.13);
  CHECK(gap_between(cone, box).distance == doctest::Approx(-0.02));
}

}  // namespace armlet
