#include "armlet/trajectory/damped_line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"

using namespace armlet;

namespace {

const Robot kArm = *make_robot("ur5");

Eigen::VectorXd joints(std::initializer_list<double> values) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(values.size()));
  std::ranges::copy(values, q.begin());
  return q;
}

// The largest distance of the tool from the straight line between two places, over the motion.
double largest_deviation(const Trajectory& motion, const Eigen::Isometry3d& T_0,
                         const Eigen::Isometry3d& T_1) {
  double largest = 0.0;
  Eigen::VectorXd q(motion.n());
  for (int k = 0; k <= 5000; ++k) {
    const double x = k / 5000.0;
    for (int i = 0; i < motion.n(); ++i) q[i] = motion.value(i, x * motion.duration());
    const double s = x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    const Eigen::Vector3d there = forward(kArm, q).translation();
    largest = std::max(largest, (there - interpolate(T_0, T_1, s).translation()).norm());
  }
  return largest;
}

LineMove along_y(const Eigen::VectorXd& q0, double distance) {
  LineMove move{.q0 = q0, .T_world_goal = forward(kArm, q0)};
  move.T_world_goal.translation().y() += distance;
  return move;
}

}  // namespace

TEST_CASE("away from singularities the damped line is the line") {
  const LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.2);
  const DampedLine damped = plan_damped_line(kArm, move, 0.02);
  const LinePlan exact = plan_line(kArm, move);
  REQUIRE(damped.ok());
  REQUIRE(exact.ok());
  CHECK(damped.deviation < 1e-6);
  CHECK(damped.length == doctest::Approx(exact.length).epsilon(1e-9));
  CHECK(damped.motion.trajectory->duration() ==
        doctest::Approx(exact.motion.trajectory->duration()).epsilon(1e-2));
}

// The wrist of the arm passes q5 = 0, where the fourth and the sixth axis are parallel.
TEST_CASE(
    "past a singular wrist no line can be followed; the damped one runs and says how far it "
    "strays") {
  const Eigen::VectorXd q0 = joints({-0.6, -1.3, 1.9, -1.1, -0.35, 0.2});
  LineMove move{.q0 = q0, .T_world_goal = forward(kArm, q0)};
  // A turn that takes the wrist close by its singularity.
  Eigen::VectorXd beyond = q0;
  beyond[4] = 0.35;
  beyond[3] += 0.1;
  move.T_world_goal = forward(kArm, beyond);
  const LinePlan exact = plan_line(kArm, move);
  const DampedLine damped = plan_damped_line(kArm, move, 0.1);
  REQUIRE(damped.ok());
  CHECK(damped.deviation > 1e-5);
  CHECK(damped.deviation < 0.05);
  REQUIRE(exact.fault);
  CHECK(exact.fault->kind != LineFaultKind::kGoal);
  // The deviation is that of the motion.
  CHECK(largest_deviation(*damped.motion.trajectory, forward(kArm, q0), move.T_world_goal) ==
        doctest::Approx(damped.deviation).epsilon(0.01));
}

TEST_CASE("a damping that is not above zero and a goal without orientation are refused") {
  LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.1);
  CHECK_THROWS_AS((void)plan_damped_line(kArm, move, 0.0), ArgumentError);
  move.task = IkTask::kTurn;
  CHECK_THROWS_AS((void)plan_damped_line(kArm, move), ArgumentError);
}

TEST_CASE("arms with fewer joints follow the place alone; the stretched arm falls short of it") {
  const Robot arm = *make_robot("planar2");  // two links of 1 m
  const Eigen::VectorXd q0 = joints({0.2, 0.9});
  LineMove move{.q0 = q0, .T_world_goal = forward(arm, joints({0.1, 1.2})), .task = IkTask::kPlace};
  const DampedLine inside = plan_damped_line(arm, move);
  REQUIRE(inside.ok());
  CHECK(inside.deviation < 1e-6);
  CHECK(inside.turn == 0.0);
  // 2.1 m from the base: a tenth of a metre beyond its reach.
  const Eigen::Vector3d axis = arm.T_world_base().translation();
  Eigen::Vector3d out = move.T_world_goal.translation() - axis;
  out *= 2.1 / out.norm();
  move.T_world_goal.translation() = axis + out;
  const DampedLine beyond = plan_damped_line(arm, move);
  REQUIRE(beyond.ok());
  CHECK(beyond.deviation == doctest::Approx(0.1).epsilon(0.02));
  CHECK(beyond.at == doctest::Approx(1.0));
}

TEST_CASE("a damped arc is the arc where nothing is singular, and none where there is none") {
  LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.2);
  const Eigen::Vector3d start = forward(kArm, move.q0).translation();
  const Eigen::Vector3d via = start + Eigen::Vector3d(0.03, 0.1, 0.0);
  const auto arc = plan_damped_arc(kArm, via, move);
  REQUIRE(arc);
  REQUIRE(arc->ok());
  CHECK(arc->deviation < 1e-6);
  CHECK(arc->length == doctest::Approx(plan_arc(kArm, via, move).length).epsilon(1e-9));
  CHECK_FALSE(plan_damped_arc(kArm, start - Eigen::Vector3d(0.0, 0.1, 0.0), move));
}
