#include "armlet/trajectory/cartesian_spline.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "motions.hpp"

using namespace armlet;

namespace {

const Robot kArm = *make_robot("ur5");
const Eigen::VectorXd kStart = (Eigen::VectorXd(6) << -0.3, -1.3, 1.9, -1.1, -1.5, 0.2).finished();

Eigen::Isometry3d tool_at(const Trajectory& motion, double t) { return tool_at(kArm, motion, t); }

Eigen::Isometry3d moved(double x, double y, double z, double turn = 0.0) {
  Eigen::Isometry3d T = forward(kArm, kStart);
  T.translation() += Eigen::Vector3d(x, y, z);
  T.linear() = T.linear() * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return T;
}

SplineMove through_four(SplineKind kind) {
  return {.q0 = kStart,
          .poses = {moved(0.0, 0.1, 0.0, 0.2), moved(0.05, 0.15, 0.05, 0.1),
                    moved(0.05, 0.15, 0.05, 0.1), moved(-0.05, 0.05, 0.1, -0.3)},
          .kind = kind};
}

}  // namespace

TEST_CASE("the tool passes every pose at its time without stopping, within all limits") {
  for (const SplineKind kind :
       {SplineKind::kCubic, SplineKind::kSpline3, SplineKind::kSpline4, SplineKind::kSpline5}) {
    const SplineMove move = through_four(kind);
    const PathPlan plan = plan_cartesian_spline(kArm, move);
    REQUIRE(plan.ok());
    const Trajectory& motion = *plan.motion.trajectory;
    REQUIRE(plan.times.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Isometry3d T = tool_at(motion, plan.times[k]);
      CHECK((T.translation() - move.poses[k].translation()).norm() < 1e-5);
      CHECK(angle_between(T, move.poses[k]) < 1e-4);
    }
    CHECK((tool_at(motion, motion.duration()).translation() - move.poses[3].translation()).norm() <
          1e-9);
    const double h = 1e-4;
    const Eigen::Vector3d v = (tool_at(motion, plan.times[1] + h).translation() -
                               tool_at(motion, plan.times[1] - h).translation()) /
                              (2.0 * h);
    CHECK(v.norm() > 0.02);
    CHECK(verify(kArm, motion).ok());
    for (int i = 0; i < 6; ++i) CHECK(motion.continuity(i, 1e-3) >= 1);
  }
}

// Between the poses the tool, not the joints, runs on the spline: the fourth differences of its
// position on one leg vanish for cubics.
TEST_CASE("between two poses the position of the tool is the cubic of the spline") {
  const PathPlan plan = plan_cartesian_spline(kArm, through_four(SplineKind::kSpline3));
  REQUIRE(plan.ok());
  const double T = plan.times[0];
  Eigen::Vector3d p[5];
  for (int k = 0; k < 5; ++k) p[k] = tool_at(*plan.motion.trajectory, T * k / 4.0).translation();
  CHECK((p[0] - 4.0 * p[1] + 6.0 * p[2] - 4.0 * p[3] + p[4]).norm() < 1e-4);
  CHECK((p[0] - 2.0 * p[2] + p[4]).norm() > 1e-3);
}

TEST_CASE(
    "one pose is a straight line with an even rotation; rotations go on past half a revolution") {
  const PathPlan one =
      plan_cartesian_spline(kArm, {.q0 = kStart, .poses = {moved(0.0, 0.2, 0.0, 0.4)}});
  REQUIRE(one.ok());
  CHECK(one.length == doctest::Approx(0.2).epsilon(1e-6));
  const Eigen::Isometry3d half = tool_at(*one.motion.trajectory, 0.5 * one.times[0]);
  CHECK((half.translation() - moved(0.0, 0.1, 0.0).translation()).norm() < 1e-5);
  CHECK(angle_between(half, moved(0.0, 0.1, 0.0, 0.2)) < 1e-4);
  SplineMove turning{.q0 = kStart};
  for (int k = 1; k <= 5; ++k) {
    Eigen::Isometry3d T = forward(kArm, kStart);
    T.linear() =
        T.linear() * Eigen::AngleAxisd(k * 0.8, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    turning.poses.push_back(T);
  }
  const PathPlan whole = plan_cartesian_spline(kArm, turning);
  REQUIRE(whole.ok());
  CHECK(whole.motion.trajectory->peak(5, 1) > 0.0);
  CHECK(std::abs(whole.motion.trajectory->end()[5] - kStart[5]) ==
        doctest::Approx(4.0).epsilon(1e-6));
}

TEST_CASE("the time that is asked for is kept, and a speed is a fraction of the fastest") {
  SplineMove move = through_four(SplineKind::kSpline3);
  const double fastest = plan_cartesian_spline(kArm, move).motion.trajectory->duration();
  move.speed = 0.5;
  CHECK(plan_cartesian_spline(kArm, move).motion.trajectory->duration() ==
        doctest::Approx(2.0 * fastest));
  move.speed = 1.0;
  move.time = 7.0;
  CHECK(plan_cartesian_spline(kArm, move).motion.trajectory->duration() == 7.0);
  move.time = 0.5 * fastest;
  const PathPlan fast = plan_cartesian_spline(kArm, move);
  CHECK_FALSE(fast.ok());
  REQUIRE(fast.motion.too_fast);
  CHECK(fast.motion.too_fast->least_time == doctest::Approx(fastest));
}

TEST_CASE("a curve that cannot be followed names the target; nothing moves nowhere") {
  SplineMove move = through_four(SplineKind::kSpline3);
  move.poses.push_back(moved(2.0, 0.0, 0.0));
  const PathPlan plan = plan_cartesian_spline(kArm, move);
  CHECK_FALSE(plan.ok());
  REQUIRE(plan.fault);
  CHECK(plan.point == 4);
  move.poses = {forward(kArm, kStart), forward(kArm, kStart)};
  CHECK(plan_cartesian_spline(kArm, move).motion.trajectory->duration() == 0.0);
  move.poses.clear();
  CHECK_THROWS_AS((void)plan_cartesian_spline(kArm, move), ArgumentError);
}
