#include "armlet/planning/way_search.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

// A planar arm of two links beside a ball that its straight path sweeps over.
struct Scene {
  std::shared_ptr<const Robot> robot = make_robot("planar2");
  Trajectory still = Trajectory::at_rest(VectorXd::Zero(2), 0.0);
  MotionScene scene;
  VectorXd start = VectorXd::Zero(2), goal = VectorXd::Zero(2);

  explicit Scene(bool blocked = true) {
    start << -0.8, 0.2;
    goal << 0.8, 0.2;
    scene.arms.push_back(
        {.robot = robot.get(), .motion = &still, .solids = robot->derived<ArmSolids>().solids()});
    Solid ball = solid_of(Shape(Sphere{0.05}));
    const Eigen::Vector3d p = forward(*robot, 0.5 * (start + goal)).translation();
    ball.T.translation() = blocked ? p : 3.0 * p;
    scene.fixed.push_back(ball);
    for (int i = 0; i < static_cast<int>(scene.arms[0].solids.size()); ++i) {
      if (scene.arms[0].solids[static_cast<std::size_t>(i)].frame > 0)
        scene.pairs.push_back({.a = {0, i}, .b = {BodyRef::kFixed, 0}});
    }
  }
};

double length_of(const std::vector<VectorXd>& points) {
  double sum = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += (points[k] - points[k - 1]).norm();
  return sum;
}

}  // namespace

TEST_CASE("a straight path is found without a search") {
  const Scene scene(false);
  const Way way = search_way(scene.scene, scene.start, {scene.goal});
  REQUIRE(way.ok());
  CHECK(way.iterations == 0);
  CHECK(way.points.size() == 2);
  CHECK(way.in_the_way.empty());
}

TEST_CASE("a path around obstacles ends exactly at its goal, and every segment of it is free" *
          doctest::skip(!can_search_ways())) {
  const Scene scene;
  const std::vector<VectorXd> ends = {scene.start, scene.goal};
  const Way way = search_way(scene.scene, scene.start, {scene.goal});
  REQUIRE(way.ok());
  CHECK(way.iterations > 0);
  CHECK(way.points.front() == scene.start);
  CHECK(way.points.back() == scene.goal);
  SegmentCheck check(scene.scene, 0.005, ends);
  for (std::size_t k = 1; k < way.points.size(); ++k)
    CHECK(check.is_free(way.points[k - 1], way.points[k]));
  // The ball leaves room on one side only: the arm has to fold.
  CHECK(way.points.size() > 2);
  CHECK(length_of(way.points) > (scene.goal - scene.start).norm());
}

TEST_CASE("shortcuts make it shorter, and joints stay within their limits" *
          doctest::skip(!can_search_ways())) {
  const Scene scene;
  const Way rough = search_way(scene.scene, scene.start, {scene.goal}, {.shortcuts = 0});
  const Way smooth = search_way(scene.scene, scene.start, {scene.goal}, {.shortcuts = 200});
  REQUIRE(rough.ok());
  REQUIRE(smooth.ok());
  CHECK(length_of(smooth.points) <= length_of(rough.points));
  for (const VectorXd& q : smooth.points) {
    for (int i = 0; i < 2; ++i) {
      CHECK(q[i] >= scene.robot->lower()[i]);
      CHECK(q[i] <= scene.robot->upper()[i]);
    }
  }
}

TEST_CASE("what makes no sense is refused") {
  const Scene scene;
  CHECK_THROWS_AS(search_way(scene.scene, scene.start, {}), ArgumentError);
  CHECK_THROWS_AS(search_way(scene.scene, VectorXd::Zero(3), {scene.goal}), ArgumentError);
  CHECK_THROWS_AS(search_way(scene.scene, scene.start, {VectorXd::Zero(1)}), ArgumentError);
  CHECK_THROWS_AS(search_way(scene.scene, scene.start, {scene.goal}, {.clearance = 0.0}),
                  ArgumentError);
  CHECK_THROWS_AS(search_way(scene.scene, scene.start, {scene.goal}, {.iterations = 0}),
                  ArgumentError);
  VectorXd nowhere = scene.goal;
  nowhere[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(search_way(scene.scene, scene.start, {nowhere}), ArgumentError);
  CHECK_THROWS_AS(search_way(MotionScene{}, scene.start, {scene.goal}), ArgumentError);
}

}  // namespace armlet
