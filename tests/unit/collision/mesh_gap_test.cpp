// Distances of meshes against bodies of the same form that are known.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/collision/contact.hpp"
#include "armlet/collision/solid.hpp"
#include "armlet/core/random.hpp"
#include "mesh_bodies.hpp"
#include "random_pose.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Core = Solid::Core;

Solid random_solid(Random& random, double spread) {
  Solid solid{.T = random_pose(random, spread)};
  const auto size = [&] { return random.uniform(0.005, 0.05); };
  switch (random.below(4)) {
    case 0:
      solid.margin = size();
      break;
    case 1:
      solid.core = Core::kSegment;
      solid.half = {0.0, 0.0, size()};
      solid.margin = size();
      break;
    case 2:
      solid.core = Core::kBox;
      solid.half = {size(), size(), size()};
      break;
    default:
      solid.core = Core::kCylinder;
      solid.half.x() = solid.half.y() = size();
      solid.half.z() = size();
      break;
  }
  return solid;
}

Solid box_solid(const Vector3d& size, const Isometry3d& T) {
  return {.core = Core::kBox, .half = 0.5 * size, .T = T};
}

// The two boxes whose union the angle iron is.
std::array<Solid, 2> iron_boxes(const Isometry3d& T) {
  return {box_solid({0.1, 0.02, 0.05}, T * Eigen::Translation3d(0.05, 0.01, 0.025)),
          box_solid({0.02, 0.1, 0.05}, T * Eigen::Translation3d(0.01, 0.05, 0.025))};
}

Solid placed(const TriangleMesh& mesh, const Isometry3d& T) {
  Solid solid = solid_of(mesh);
  solid.T = T;
  return solid;
}

}  // namespace

TEST_CASE("a box of triangles is as far from everything as a box") {
  Random random(11);
  double worst_apart = 0.0, worst_depth = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d size =
        2.0 * (random_vector(random, 0.04).cwiseAbs() + Vector3d::Constant(0.005));
    const TriangleMesh mesh = test::box_mesh(size);
    const Isometry3d T = random_pose(random, 0.08);
    const Solid of_triangles = placed(mesh, T), box = box_solid(size, T);
    REQUIRE(of_triangles.core == Core::kHull);
    const Solid other = random_solid(random, 0.08);
    const double wanted = gap_between(box, other).distance;
    const double found = gap_between(of_triangles, other).distance;
    double& worst = wanted > 0.0 ? worst_apart : worst_depth;
    worst = std::max(worst, std::abs(found - wanted));
    if (wanted < -1e-6) {
      const Vector3d n = contact_normal(box, other);
      // Nearly along a face a rounding error of the gap counts for many times as much.
      CHECK(std::abs(depth_along(of_triangles, other, n) - depth_along(box, other, n)) < 1e-7);
    }
  }
  CHECK(worst_apart < 2e-9);
  CHECK(worst_depth < 2e-7);
}

TEST_CASE("a box of triangles on a table is carried where a box is") {
  Random random(12);
  const Solid table = box_solid({0.4, 0.3, 0.02}, Isometry3d::Identity());
  for (int i = 0; i < 500; ++i) {
    const Vector3d size(0.06, 0.04, 0.05);
    const TriangleMesh mesh = test::box_mesh(size);
    Isometry3d T(Eigen::AngleAxisd(random.uniform(0, 3), Vector3d::UnitZ()));
    T.translation() = Vector3d(random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15), 0.0345);
    const Solid cube = placed(mesh, T), box = box_solid(size, T);
    const Vector3d n = contact_normal(cube, table);
    CHECK((n - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK((pressure_point(cube, table, n) - pressure_point(box, table, n)).norm() < 1e-9);
    CHECK(depth_along(cube, table, n) == doctest::Approx(5e-4).epsilon(1e-6));
  }
}

TEST_CASE("an angle iron is as far from everything as the nearer of its boxes") {
  Random random(13);
  const TriangleMesh iron = test::angle_iron();
  int apart = 0, overlaps = 0, in_hull = 0;
  for (int i = 0; i < 4000; ++i) {
    const Isometry3d T = random_pose(random, 0.06);
    const Solid mesh = placed(iron, T);
    REQUIRE(mesh.core == Core::kMesh);
    Solid other = random_solid(random, 0.06);
    if (i % 3 == 0) other.half *= 0.1, other.margin *= 0.1;
    if (other.is_empty()) continue;
    const auto boxes = iron_boxes(T);
    const Gap first = gap_between(boxes[0], other), second = gap_between(boxes[1], other);
    const double wanted = std::min(first.distance, second.distance);
    const Gap found = gap_between(mesh, other), back = gap_between(other, mesh);
    Solid hull = mesh;
    hull.core = Core::kHull;
    const double in_the_hull = gap_between(hull, other).distance;
    CHECK(std::abs(found.away.norm() - 1.0) < 1e-9);
    if (wanted > 1e-7) {
      ++apart;
      if (in_the_hull < 0.0) ++in_hull;
      CHECK(std::abs(found.distance - wanted) < 2e-9);
      CHECK(std::abs((found.p_a - found.p_b).norm() - found.distance) < 1e-8);
      CHECK(is_farther(mesh, other, wanted - 1e-8));
      CHECK_FALSE(is_farther(mesh, other, wanted + 1e-8));
    } else if (wanted < -1e-6) {
      ++overlaps;
      CHECK(found.distance < 0.0);
      CHECK(found.distance >= in_the_hull - 1e-7);
      CHECK_FALSE(is_farther(mesh, other, 0.0));
    }
    CHECK(std::abs(back.distance - found.distance) < 2e-7);
  }
  CHECK(apart > 1000);
  CHECK(overlaps > 800);
  CHECK(in_hull > 50);
}

TEST_CASE("what is pressed into a face is as deep as the face says, and leaves along its normal") {
  const TriangleMesh iron = test::angle_iron();
  Solid mesh = placed(iron, Isometry3d::Identity());
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    const double depth = random.uniform(1e-5, 3e-3);
    Solid ball;
    ball.margin = 0.01;
    // On the long leg, beside the other one.
    ball.T.translation() = Vector3d(random.uniform(0.035, 0.085), 0.03 - depth, 0.025);
    const Gap gap = gap_between(ball, mesh);
    CHECK(gap.distance == doctest::Approx(-depth).epsilon(1e-6));
    CHECK((gap.away - Vector3d::UnitY()).norm() < 1e-5);
    CHECK(depth_along(ball, mesh, Vector3d::UnitY()) == doctest::Approx(depth).epsilon(1e-5));
  }
}

TEST_CASE("what lies inside without touching the surface overlaps") {
  const TriangleMesh iron = test::angle_iron();
  const Solid mesh = placed(iron, Isometry3d::Identity());
  Solid ball;
  ball.margin = 0.004;
  ball.T.translation() = Vector3d(0.05, 0.01, 0.025);
  const Gap gap = gap_between(mesh, ball);
  // Out through the nearer face: 10 mm to it and the radius.
  CHECK(gap.distance == doctest::Approx(-0.014).epsilon(1e-9));
  CHECK_FALSE(is_farther(mesh, ball, 0.0));
  ball.T.translation() += gap.distance * gap.away;  // the ball moves in the opposite direction
  CHECK(std::abs(gap_between(mesh, ball).distance) < 1e-9);
}

TEST_CASE("two angle irons are as far apart as their nearest boxes") {
  Random random(15);
  const TriangleMesh iron = test::angle_iron();
  int apart = 0, overlaps = 0;
  for (int i = 0; i < 600; ++i) {
    const Isometry3d T_a = random_pose(random, 0.08), T_b = random_pose(random, 0.08);
    const Solid a = placed(iron, T_a), b = placed(iron, T_b);
    double wanted = 1.0;
    for (const Solid& x : iron_boxes(T_a)) {
      for (const Solid& y : iron_boxes(T_b)) wanted = std::min(wanted, gap_between(x, y).distance);
    }
    const double found = gap_between(a, b).distance;
    if (wanted > 1e-7) {
      ++apart;
      CHECK(std::abs(found - wanted) < 2e-9);
    } else if (wanted < -1e-6) {
      ++overlaps;
      CHECK(found < 0.0);
    }
    CHECK(is_farther(a, b, 0.0) == (found > 0.0));
  }
  CHECK(apart > 100);
  CHECK(overlaps > 100);
}

TEST_CASE("an open surface is there as a sheet") {
  auto triangles = test::box_mesh({0.1, 0.1, 0.1}).triangles();
  triangles.pop_back();
  const TriangleMesh open(test::box_mesh({0.1, 0.1, 0.1}).vertices(), triangles);
  const Solid mesh = placed(open, Isometry3d::Identity());
  Solid ball;
  ball.margin = 0.01;
  CHECK(gap_between(mesh, ball).distance == doctest::Approx(0.04));
  ball.T.translation() = Vector3d(0.0, 0.0, 0.055);
  CHECK(gap_between(mesh, ball).distance == doctest::Approx(-0.005));
}

TEST_CASE("a depth that does not free is known to be a lower bound, one that does is whole") {
  const TriangleMesh coarse = test::angle_iron();
  const TriangleMesh fine = test::hollow_box(0.2, 20);
  REQUIRE(fine.is_closed());
  Random random(148);
  int whole = 0, bound = 0;
  for (int i = 0; i < 400; ++i) {
    const Solid mesh = placed(i % 2 == 0 ? coarse : fine, random_pose(random, 0.05));
    const Solid other = random_solid(random, 0.12);
    const Gap gap = gap_between(other, mesh);
    if (gap.distance > -1e-5) continue;
    Solid moved = other;
    moved.T.translation() += (1e-6 - gap.distance) * gap.away;
    const bool frees = gap_between(moved, mesh).distance > -1e-6;
    CHECK(is_whole_depth(other, mesh, gap) == frees);
    ++(frees ? whole : bound);
    // Never more than what surely frees: the hull.
    CHECK(-gap.distance <= 0.5);
  }
  CHECK(whole > 30);
  CHECK(bound > 30);
  // A ball that is pressed 1 mm into a face from outside, and one that sits in the wall.
  const Solid box = placed(fine, Isometry3d::Identity());
  Solid pea{.margin = 0.01};
  pea.T.translation() = Vector3d(0.0131, 0.0172, 0.1 + 0.009);
  const Gap pressed = gap_between(pea, box);
  CHECK(pressed.distance == doctest::Approx(-0.001).epsilon(1e-6));
  CHECK(is_whole_depth(pea, box, pressed));
  // Convex bodies always.
  const Solid cube = box_solid({0.1, 0.1, 0.1}, Isometry3d::Identity());
  pea.T.translation() = Vector3d(0.0, 0.0, 0.05);
  CHECK(is_whole_depth(pea, cube, gap_between(pea, cube)));
}

}  // namespace armlet
