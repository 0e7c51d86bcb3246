#include "armlet/cell/clearance.hpp"

#include <doctest/doctest.h>

#include <array>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "mesh_bodies.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

Object ball(const std::string& name, double radius, const Vector3d& p) {
  Object object;
  object.name = name;
  object.shape = Sphere{radius};
  object.T_world_obj.translation() = p;
  object.fixed = true;
  return object;
}

struct Bench {
  Cell cell;
  int arm = cell.add_robot(std::make_shared<const Robot>(*make_robot("puma560")));

  [[nodiscard]] std::vector<Clearance> look(double reach = 10.0) const {
    return clearances(cell, arm, reach, 8);
  }
};

}  // namespace

TEST_CASE("the nearest object is found, with points as far apart as is said") {
  Bench bench;
  bench.cell.insert(ball("far", 0.1, {0.0, 3.0, 0.5}));
  bench.cell.insert(ball("near", 0.1, {0.0, 1.5, 0.5}));
  const std::vector<Clearance> found = bench.look();
  REQUIRE(found.size() == 1);
  CHECK(found[0].other.object == "near");
  CHECK(found[0].body.robot == bench.arm);
  CHECK(found[0].distance == doctest::Approx((found[0].p_body - found[0].p_other).norm()));
  // The point of the ball lies on it, towards the other one.
  CHECK((found[0].p_other - Vector3d(0.0, 1.5, 0.5)).norm() == doctest::Approx(0.1));
  const CellBody arm{.robot = bench.arm}, near{.object = "near"};
  CHECK(found[0].distance <= distance_between(bench.cell, arm, near) + 1e-9);
  CHECK(bench.look(0.9 * found[0].distance).empty());
}

TEST_CASE("overlaps are reported alone, the deepest first, and as deep as distance_between says") {
  Bench bench;
  const Vector3d p =
      forward(*bench.cell.robot(bench.arm).model, bench.cell.robot(bench.arm).q).translation();
  bench.cell.insert(ball("shallow", 0.05, p + Vector3d(0.0, 0.04, 0.0)));
  bench.cell.insert(ball("deep", 0.2, p));
  bench.cell.insert(ball("apart", 0.1, {0.0, 2.5, 0.5}));
  const std::vector<Clearance> found = bench.look();
  REQUIRE(found.size() == 2);
  CHECK(found[0].other.object == "deep");
  CHECK(found[1].other.object == "shallow");
  for (const Clearance& each : found) {
    CHECK(each.distance < 0.0);
    const CellBody arm{.robot = bench.arm}, other{.object = each.other.object};
    CHECK(each.distance == doctest::Approx(distance_between(bench.cell, arm, other)));
  }
}

TEST_CASE(
    "random balls: as far as their points are, on the ball, and never nearer than any part of the "
    "arm") {
  Random random(7);
  int seen = 0;
  for (int k = 0; k < 200; ++k) {
    Bench bench;
    Eigen::VectorXd q = bench.cell.robot(bench.arm).q;
    const Robot& model = *bench.cell.robot(bench.arm).model;
    for (int i = 0; i < model.n(); ++i)
      q[i] = model.lower()[i] + random.uniform() * (model.upper()[i] - model.lower()[i]);
    bench.cell.set_joints(bench.arm, q);
    // Outside of the column around which nothing is compared.
    const double turn = 6.28 * random.uniform();
    const Vector3d p(0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.4 + 0.5 * random.uniform());
    bench.cell.insert(ball("ball", 0.05, p));
    const std::vector<Clearance> found = bench.look();
    for (const Clearance& each : found) {
      if (each.other.object != "ball") continue;
      // The base, which is not compared with what stands around it, may be nearer.
      const double least = distance_between(bench.cell, {.robot = bench.arm}, {.object = "ball"});
      CHECK(each.distance >= least - 1e-9);
      if (each.distance <= 0.0) continue;
      CHECK(each.distance == doctest::Approx((each.p_body - each.p_other).norm()).epsilon(1e-6));
      CHECK((each.p_other - p).norm() == doctest::Approx(0.05).epsilon(1e-6));
      ++seen;
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("what is mounted and held counts as the arm, and the witness is named") {
  Bench bench;
  Cell& cell = bench.cell;
  const Vector3d p = cell.T_world_tool(bench.arm).translation();
  Object mast = ball("mast", 0.05, Vector3d(0.0, 0.4, 0.0));
  mast.shape = Box{{0.02, 0.02, 0.2}};
  cell.insert(mast, {.base = FrameBase::kCarrier, .carrier = bench.arm, .frame = 6});
  const Vector3d middle = cell.world().at("mast").T_world_obj.translation();
  cell.insert(ball("target", 0.02, middle + Vector3d(0.0, 0.0, 1.0)));
  const CellBody arm{.robot = bench.arm}, target{.object = "target"};
  const Clearance without = nearest_between(cell, arm, target, Carried::kLeftOut);
  CHECK(without.body.object.empty());
  Object held = ball("held", 0.03, p);
  held.fixed = false;
  cell.insert(held);
  cell.take(bench.arm, "held");
  cell.set_pose("target", Eigen::Isometry3d(Eigen::Translation3d(p + Vector3d(0.0, 0.0, 0.2))));
  const Clearance now = nearest_between(cell, arm, target);
  const Clearance mirrored = nearest_between(cell, target, arm);
  CHECK(now.distance == doctest::Approx(mirrored.distance));
  CHECK(now.distance <= nearest_between(cell, arm, target, Carried::kLeftOut).distance);
  CHECK(now.distance == doctest::Approx((now.p_body - now.p_other).norm()));
  CHECK(now.other.object == "target");
  // Beside the mast alone.
  Eigen::Isometry3d beside = Eigen::Isometry3d::Identity();
  beside.translation() = cell.world().at("mast").T_world_obj * Vector3d(0.0, 0.0, 0.15);
  cell.set_pose("target", beside);
  const Clearance mounted = nearest_between(cell, arm, target);
  CHECK(mounted.body.object == "mast");
  CHECK(mounted.body.robot == bench.arm);
  CHECK(mounted.distance == doctest::Approx(0.03));
  CHECK(nearest_between(cell, arm, target, Carried::kLeftOut).distance > mounted.distance);
  // It is no part of the arm when it is asked about itself.
  CHECK(nearest_between(cell, arm, {.object = "held"}).body.object != "held");
  CHECK(nearest_between(cell, arm, {.object = "mast"}).body.object != "mast");
}

TEST_CASE("a depth that is a lower bound is reported as one, and one that is whole is not") {
  // How many of some positions around the tool have an overlap, and how many of these are bounds.
  const auto count = [](const Shape& shape) {
    std::array<int, 2> found{};
    Random random(164);
    for (int i = 0; i < 40; ++i) {
      Bench bench;
      const Vector3d p = bench.cell.T_world_tool(bench.arm).translation();
      const Vector3d off(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
      Object thing = ball("thing", 0.1, p + 0.6 * off);
      thing.shape = shape;
      bench.cell.insert(thing);
      for (const Clearance& each : bench.look()) {
        found[0] += each.distance < -1e-3 ? 1 : 0;
        found[1] += each.at_least ? 1 : 0;
      }
    }
    return found;
  };
  const auto hollow = count(make_mesh(test::hollow_box(0.4, 20)));
  const auto whole = count(Box{{0.4, 0.4, 0.4}});
  CAPTURE(hollow[0]);
  CAPTURE(hollow[1]);
  CHECK(hollow[1] > 5);
  CHECK(hollow[0] > 20);
  CHECK(whole[0] > 20);
  CHECK(whole[1] == 0);
}

TEST_CASE("a robot that has nothing around it is near nothing") {
  Bench bench;
  CHECK(bench.look().empty());
}

}  // namespace armlet
