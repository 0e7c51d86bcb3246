#include "armlet/collision/segment_check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd random_joints(const Robot& robot, Random& random) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] = random.uniform(std::max(robot.lower()[i], -3.0), std::min(robot.upper()[i], 3.0));
  return q;
}

// An arm that stands, against one fixed body.
struct Scene {
  Trajectory still;
  MotionScene scene;

  Scene(const Robot& robot, const Solid& body)
      : still(Trajectory::at_rest(VectorXd::Zero(robot.n()), 0.0)) {
    scene.arms.push_back(
        {.robot = &robot, .motion = &still, .solids = robot.derived<ArmSolids>().solids()});
    scene.fixed.push_back(body);
    for (int i = 0; i < static_cast<int>(scene.arms[0].solids.size()); ++i) {
      if (scene.arms[0].solids[static_cast<std::size_t>(i)].frame > 0)
        scene.pairs.push_back({.a = {0, i}, .b = {BodyRef::kFixed, 0}});
    }
  }

  // The smallest gap at a position, placed without the code under test.
  [[nodiscard]] double gap_at(const VectorXd& q) const {
    double least = 1e9;
    for (const CheckedPair& pair : scene.pairs) {
      const ArmSolid& own = scene.arms[0].solids[static_cast<std::size_t>(pair.a.index)];
      Solid solid = own.solid;
      solid.T = link_frame(*scene.arms[0].robot, q, own.frame) * own.solid.T;
      least = std::min(least, gap_between(solid, scene.fixed[0]).distance);
    }
    return least;
  }
};

Solid random_body(Random& random, const Vector3d& p) {
  Solid body = random.below(2) == 0
                   ? solid_of(Shape(Box{{random.uniform(0.001, 0.2), random.uniform(0.05, 0.4),
                                         random.uniform(0.05, 0.4)}}))
                   : solid_of(Shape(Sphere{random.uniform(0.01, 0.15)}));
  const Vector3d axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.5);
  body.T.linear() =
      Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis.normalized()).toRotationMatrix();
  body.T.translation() = p;
  return body;
}

}  // namespace

// A free segment keeps 5 mm in all samples, less 5 % of it. A blocked segment comes closer than 5
// mm and a quarter in some sample, unless it does so only between two samples.
TEST_CASE("segments that are free stay apart in dense samples, and others come near") {
  constexpr double kClearance = 0.005;
  Random random(6);
  int free = 0, blocked = 0, unseen = 0;
  for (const char* name : {"puma560", "ur5", "scara"}) {
    const auto robot = make_robot(name);
    for (int round = 0; round < 150; ++round) {
      const VectorXd q0 = random_joints(*robot, random), q1 = random_joints(*robot, random);
      const VectorXd on_way = q0 + random.uniform() * (q1 - q0);
      const Vector3d near(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.1);
      const Scene scene(*robot, random_body(random, forward(*robot, on_way).translation() + near));
      SegmentCheck check(scene.scene, kClearance, {});
      const bool is_free = check.is_free(q0, q1);
      double least = 1e9;
      for (int k = 0; k <= 500; ++k)
        least = std::min(least, scene.gap_at(q0 + k / 500.0 * (q1 - q0)));
      if (is_free) {
        CHECK(least >= 1.05 * kClearance - 1e-9);
      } else if (least > 1.25 * kClearance) {
        ++unseen;
      }
      ++(is_free ? free : blocked);
    }
  }
  CHECK(free > 60);
  CHECK(blocked > 60);
  CHECK(unseen <= 2);
}

TEST_CASE("a wall of 1 mm between both ends is never passed through") {
  const auto robot = make_robot("scara");
  const VectorXd q0 = robot->home();
  VectorXd q1 = q0;
  q1[0] -= 1.5;
  const VectorXd middle = 0.5 * (q0 + q1);
  Solid wall = solid_of(Shape(Box{{0.001, 0.4, 0.6}}));
  const Eigen::Isometry3d T = link_frame(*robot, middle, 1);
  wall.T.translation() = T.translation();
  const double angle = std::atan2(T.translation().y(), T.translation().x()) + 1.5707963267948966;
  wall.T.linear() = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  const Scene scene(*robot, wall);
  SegmentCheck check(scene.scene, 0.005, {});
  CHECK(check.is_free(q0));
  CHECK(check.is_free(q1));
  CHECK_FALSE(check.is_free(q0, q1));
  std::uint64_t times = 0;
  for (const std::uint64_t each : check.blocked()) times += each;
  CHECK(times == 1);
}

TEST_CASE("where an end is nearer than the clearance, half of what it has is kept") {
  const auto robot = make_robot("scara");
  const VectorXd q = robot->home();
  Solid ball = solid_of(Shape(Sphere{0.05}));
  ball.T.translation() = forward(*robot, q).translation() - Vector3d(0.0, 0.0, 0.2);
  const double gap = Scene(*robot, ball).gap_at(q);
  ball.T.translation().z() += gap - 0.002;
  const Scene scene(*robot, ball);
  CHECK(scene.gap_at(q) == doctest::Approx(0.002).epsilon(1e-3));
  const std::vector<VectorXd> ends = {q};
  CHECK_FALSE(SegmentCheck(scene.scene, 0.005, {}).is_free(q));
  SegmentCheck check(scene.scene, 0.005, ends);
  CHECK(check.is_free(q));
  VectorXd lower = q;
  CHECK(check.kept()[static_cast<std::size_t>(std::ranges::min_element(check.kept()) -
                                              check.kept().begin())] ==
        doctest::Approx(0.001).epsilon(1e-3));
  lower[2] += 0.0012;
  CHECK_FALSE(check.is_free(lower));
  lower[2] += 0.01;
  const std::vector<Overlap> overlaps = check.overlaps(lower);
  REQUIRE_FALSE(overlaps.empty());
  CHECK(overlaps[0].depth == doctest::Approx(0.0092).epsilon(0.02));
}

TEST_CASE("an end with a quarter more room than the clearance takes nothing from it") {
  const auto robot = make_robot("scara");
  const VectorXd q = robot->home();
  Solid ball = solid_of(Shape(Sphere{0.05}));
  ball.T.translation() = forward(*robot, q).translation() - Vector3d(0.0, 0.0, 0.2);
  const double gap = Scene(*robot, ball).gap_at(q);
  const double z = ball.T.translation().z();
  const auto kept = [&](double room) {
    ball.T.translation().z() = z + gap - room;
    const Scene scene(*robot, ball);
    const std::vector<VectorXd> ends = {q};
    return std::ranges::min(SegmentCheck(scene.scene, 0.004, ends).kept());
  };
  CHECK(kept(0.0051) == 0.004);
  CHECK(kept(0.0045) == doctest::Approx(0.0035).epsilon(1e-3));
  CHECK(kept(0.002) == doctest::Approx(0.001).epsilon(1e-3));
  CHECK(kept(0.0001) < 0.0);
}

TEST_CASE("ends of another size are refused") {
  const auto robot = make_robot("scara");
  const Scene scene(*robot, solid_of(Shape(Sphere{0.05})));
  const std::vector<VectorXd> ends = {VectorXd::Zero(2)};
  CHECK_THROWS_AS(SegmentCheck(scene.scene, 0.005, ends), ArgumentError);
}

}  // namespace armlet
