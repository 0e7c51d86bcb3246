#include "armlet/trajectory/motion_forces.hpp"

#include <doctest/doctest.h>

#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

// One joint of 2 kg m^2, without gravity, that gives 3 N m.
Robot wheel() {
  RobotSpec spec;
  Joint joint;
  joint.max_effort = 3.0;
  spec.joints.push_back(joint);
  Link link;
  link.mass = 1.0;
  link.inertia = 2.0 * Eigen::Matrix3d::Identity();
  spec.links.push_back(link);
  return Robot(spec);
}

Trajectory fastest(const Robot& robot, const VectorXd& q0, const VectorXd& q1) {
  const PlannerSet planners;
  const MotionPlan plan = plan_joint_move(planners, robot, {.q0 = q0, .q1 = q1, .speed = 1.0});
  REQUIRE(plan.ok());
  return *plan.trajectory;
}

}  // namespace

TEST_CASE("the force of a joint that nothing else loads is its inertia times its acceleration") {
  const Robot robot = wheel();
  const Trajectory motion = fastest(robot, VectorXd::Zero(1), VectorXd::Constant(1, 1.0));
  const MotionForces forces = motion_forces(robot, motion);
  CHECK(std::abs(forces.peaks[0].force) == doctest::Approx(2.0 * motion.peak(0, 2)).epsilon(1e-4));
  CHECK(forces.nearest == 0);
  CHECK(forces.slower == doctest::Approx(std::sqrt(2.0 * motion.peak(0, 2) / 3.0)).epsilon(1e-4));
}

// With k from motion_forces the slowed motion is just within the limits.
TEST_CASE("a motion that is so many times slower keeps the limits, one a little faster does not") {
  Random random(31);
  int tried = 0;
  for (int k = 0; k < 60; ++k) {
    const int n = 2 + k % 5;
    Robot robot = random_heavy_arm(random, n);
    const VectorXd q0 = random_values(random, n), q1 = random_values(random, n);
    RobotSpec spec = robot.spec();
    const Trajectory motion = fastest(robot, q0, q1);
    const MotionForces free = motion_forces(robot, motion);
    CHECK(free.nearest == -1);
    CHECK(free.slower == 0.0);
    const MotionForces holding = motion_forces(robot, motion.stretched(1000.0));
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double held = std::abs(holding.peaks[at].force), most = std::abs(free.peaks[at].force);
      spec.joints[at].max_effort = 1e-3 + held + random.uniform(0.4, 1.1) * std::abs(most - held);
    }
    robot = Robot(spec);
    const MotionForces forces = motion_forces(robot, motion);
    if (!std::isfinite(forces.slower) || forces.slower <= 1.0) continue;
    ++tried;
    const auto share = [&](double factor) {
      const MotionForces now = motion_forces(robot, motion.stretched(factor));
      return now.peaks[static_cast<std::size_t>(now.nearest)].share();
    };
    CHECK(share(forces.slower * 1.001) < 1.001);
    CHECK(share(forces.slower * 0.98) > 1.0);
  }
  CHECK(tried > 30);
}

// Against instants 20 times closer, where limits are just above and just below what is asked for:
// whether they are kept decides whether it is worked out how much slower the motion has to be.
TEST_CASE("the largest share of a limit is found, and whether it is kept") {
  const PlannerSet planners;
  Random random(33);
  int kept = 0, exceeded = 0;
  for (int k = 0; k < 150; ++k) {
    CAPTURE(k);
    const int n = 2 + k % 5;
    RobotSpec spec = random_heavy_arm(random, n).spec();
    const VectorXd q0 = random_values(random, n), q1 = random_values(random, n);
    const char* const laws[] = {"Syn", "434", "SCurve"};
    const MotionPlan plan = plan_joint_move(planners, Robot(spec),
                                            {.q0 = q0,
                                             .q1 = q1,
                                             .planner = laws[k % 3],
                                             .time = random.uniform(0.3, 3.0),
                                             .enforce_limits = false});
    if (!plan.ok()) continue;
    const Trajectory& motion = *plan.trajectory;
    VectorXd q(n), qd(n), qdd(n), most = VectorXd::Zero(n);
    constexpr double kClose = 2.5e-4;  // s
    for (double t = 0.5 * kClose; t < motion.duration(); t += kClose) {
      motion.sample(t, q, qd, qdd);
      most = most.cwiseMax(VectorXd(inverse_dynamics(Robot(spec), q, qd, qdd)).cwiseAbs());
    }
    double share = 0.0;
    for (int i = 0; i < n; ++i) {
      const double limit = random.uniform(0.98, 1.3) * most[i];
      spec.joints[static_cast<std::size_t>(i)].max_effort = limit;
      share = std::max(share, most[i] / limit);
    }
    const MotionForces forces = motion_forces(Robot(spec), motion);
    CHECK(forces.peaks[static_cast<std::size_t>(forces.nearest)].share() >= share * (1.0 - 1e-4));
    if (share > 1.0) CHECK(forces.slower > 1.0);
    ++(share > 1.0 ? exceeded : kept);
  }
  CHECK(kept > 20);
  CHECK(exceeded > 20);
}

// Against motion_forces, which looks closer, of the same motion.
TEST_CASE("what a velocity command asks for while it holds is found") {
  constexpr double kHolds = 0.7;  // s
  Random random(32);
  int before = 0, after = 0;
  for (int k = 0; k < 80; ++k) {
    CAPTURE(k);
    const int n = 2 + k % 5;
    RobotSpec spec = random_heavy_arm(random, n).spec();
    for (Joint& joint : spec.joints) joint.max_effort = 10.0;
    const Robot robot(spec);
    const VelocityPlan plan = plan_joint_velocity(
        robot, {.q = random_values(random, n), .qd = VectorXd::Zero(n), .during = kHolds},
        0.3 * random_values(random, n));
    if (!plan.motion) continue;
    const MotionForces all = motion_forces(robot, *plan.motion);
    const MotionForces held = command_forces(robot, *plan.motion, 0.0, kHolds);
    for (std::size_t i = 0; i < all.peaks.size(); ++i) {
      const double most = std::abs(all.peaks[i].force);
      CHECK(std::abs(held.peaks[i].force) <= most * (1.0 + 1e-6));
      CHECK(held.peaks[i].t <= kHolds);
      ++(all.peaks[i].t > kHolds ? after : before);
      if (all.peaks[i].t < kHolds) CHECK(std::abs(held.peaks[i].force) >= 0.98 * most - 1e-9);
    }
  }
  CHECK(before > 20);
  CHECK(after > 20);
}

TEST_CASE("where the weight alone is too much no speed helps") {
  RobotSpec spec = wheel().spec();
  spec.links[0].mass = 10.0;
  spec.links[0].com = {0.5, 0.0, 0.0};
  spec.gravity = {0.0, -9.81, 0.0};  // across the axis: up to 49 N m
  const Robot robot(spec);
  const MotionForces forces =
      motion_forces(robot, fastest(robot, VectorXd::Zero(1), VectorXd::Constant(1, 0.5)));
  CHECK(std::isinf(forces.slower));
}
