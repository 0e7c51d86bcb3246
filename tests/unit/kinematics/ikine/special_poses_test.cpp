// Poses at which formulas divide by zero: arms with equal links, right angles and no offsets, with
// joints folded, stretched and at right angles, so that the target lies on an axis, several
// solutions touch, or a joint is free. Each pose is taken by the arm, so a solution
// has to be found.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "arm_of_rows.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

constexpr double kRight = kPi / 2;

double one_of(Random& random, std::initializer_list<double> values) {
  return *(values.begin() + random.below(values.size()));
}

double special_length(Random& random) {
  return one_of(random, {0.0, 0.0, 0.3, 0.3, 0.3, -0.3, 0.2});
}
double special_twist(Random& random) {
  return one_of(random, {0.0, 0.0, kRight, -kRight, kPi, kRight, -kRight, 0.7});
}
double cross_twist(Random& random) { return one_of(random, {kRight, -kRight, kRight, 0.9}); }

void make_parallel(RobotSpec& spec, Random& random, int first, int last) {
  const auto alpha = [&](int i) -> double& {
    return spec.joints[static_cast<std::size_t>(i)].dh.alpha;
  };
  if (first > 0) alpha(first - 1) = cross_twist(random);
  for (int i = first; i < last; ++i) alpha(i) = one_of(random, {0.0, 0.0, kPi});
  if (last + 1 < static_cast<int>(spec.joints.size())) alpha(last) = cross_twist(random);
}
// Axes first to last meet in a point.
void make_meet(RobotSpec& spec, Random& random, int first, int last) {
  for (int i = first; i < last; ++i) {
    DhRow& row = spec.joints[static_cast<std::size_t>(i)].dh;
    row.a = 0.0;
    row.alpha = cross_twist(random);
    if (i > first) row.d = 0.0;
  }
}

// Half of the arms have the structure of a family.
void give_structure(RobotSpec& spec, Random& random) {
  const int n = static_cast<int>(spec.joints.size());
  const bool second = random.below(2) == 0;
  if (n == 3) make_parallel(spec, random, second ? 0 : 1, 2);
  if (n == 4) {
    make_parallel(spec, random, 0, 3);
    Joint& slide = spec.joints[random.below(4)];
    slide.kind = JointKind::kPrismatic;
    slide.lower = -1.0;
    slide.upper = 1.0;
  }
  if (n == 5) make_parallel(spec, random, 1, 3);
  if (n == 6 && second) {
    make_parallel(spec, random, 1, 3);
    make_meet(spec, random, 4, 5);
  } else if (n == 6) {
    make_meet(spec, random, 3, 5);
    if (random.below(2) == 0)
      make_parallel(spec, random, 1, 2);
    else
      make_meet(spec, random, 0, 1);
  }
  if (n == 7) {
    make_meet(spec, random, 0, 2);
    make_meet(spec, random, 4, 6);
    spec.joints[2].dh.alpha = cross_twist(random);
  }
}

RobotSpec special_arm(Random& random, int n) {
  RobotSpec spec;
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.dh = {one_of(random, {0.0, 0.0, kRight, kPi}), special_length(random),
                special_length(random), special_twist(random)};
    spec.joints.push_back(joint);
  }
  if (random.below(2) == 0) give_structure(spec, random);
  if (random.below(2) == 0) {
    spec.T_flange_tool =
        make_translation({special_length(random), special_length(random), special_length(random)});
  }
  return spec;
}

VectorXd special_joints(Random& random, const Robot& robot) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    q[i] = one_of(random, {0.0, kRight, -kRight, kPi});
    switch (random.below(10)) {
      case 0:
        q[i] = random.uniform(-3.0, 3.0);
        break;
      case 1:  // equal links may close to a triangle
        q[i] = one_of(random, {kPi / 3, 2 * kPi / 3, -2 * kPi / 3});
        break;
      case 2:  // next to a special value
        q[i] += one_of(random, {1e-3, 1e-5, -1e-6, 1e-7, -1e-8, 1e-9, 1e-10, 1e-12});
        break;
      default:
        break;
    }
    if (!robot.is_revolute(i)) q[i] = one_of(random, {0.0, 0.3, -0.3});
  }
  return q;
}

bool reaches(const Robot& robot, const VectorXd& q, const Isometry3d& goal, bool heading_counts) {
  const Isometry3d reached = forward(robot, q);
  return (reached.translation() - goal.translation()).norm() < 1.001e-6 &&
         (!heading_counts || angle_between(reached, goal) < 1.001e-6) && within_limits(robot, q);
}

// Limits around q, between 0 and 2 rad or 0.5 m away.
void set_limits_around(RobotSpec& spec, Random& random, const VectorXd& q) {
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    Joint& joint = spec.joints[i];
    const double most = joint.is_revolute() ? 2.0 : 0.5;
    joint.lower = q[static_cast<Eigen::Index>(i)] - random.uniform(0.0, most);
    joint.upper = q[static_cast<Eigen::Index>(i)] + random.uniform(0.0, most);
  }
}

enum class Limits { kWide, kAround };

// How many of the special poses of `arms` arms solve_ik and solve_ik_all miss.
struct Missed {
  int one = 0;
  int all = 0;
};
Missed missed(int n, int arms, Limits limits) {
  Random random(static_cast<std::uint64_t>(40 + n));
  Missed out;
  for (int k = 0; k < arms; ++k) {
    RobotSpec spec = special_arm(random, n);
    const VectorXd q = special_joints(random, Robot(spec));
    if (limits == Limits::kAround) set_limits_around(spec, random, q);
    const Robot robot(spec);
    const Isometry3d goal = forward(robot, q);
    VectorXd seed = VectorXd::Zero(n);
    if (random.below(3) != 0) {
      for (double& value : seed) value = random.uniform(-1.0, 1.0);
    }
    seed = clamp_to_limits(robot, seed);
    for (const IkTask task : {IkTask::kPose, IkTask::kPosition}) {
      const bool heading_counts = task == IkTask::kPose;
      const IkOptions options{.seed = seed, .task = task};
      const IkResult ik = solve_ik(robot, goal, options);
      out.one += ik.ok() && reaches(robot, ik.q, goal, heading_counts) ? 0 : 1;
      if (limits == Limits::kAround) continue;
      const auto all = solve_ik_all(robot, goal, options);
      const auto good = [&](const VectorXd& s) { return reaches(robot, s, goal, heading_counts); };
      out.all += !all.empty() && std::ranges::all_of(all, good) ? 0 : 1;
    }
  }
  return out;
}

}  // namespace

TEST_CASE("a pose that an arm of special lengths takes with special joints is always found") {
  for (int n = 1; n <= 7; ++n) {
    CAPTURE(n);
    const Missed wide = missed(n, 800, Limits::kWide);
    CHECK(wide.one == 0);
    CHECK(wide.all == 0);
    CHECK(missed(n, 250, Limits::kAround).one == 0);
  }
}

TEST_CASE("arms of one to twelve joints, revolute and prismatic, find the poses that they take") {
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    Random random(static_cast<std::uint64_t>(n));
    int missed = 0;
    for (int k = 0; k < 30; ++k) {
      const Robot robot = random_arm(random, n);
      for (int j = 0; j < 20; ++j) {
        const Isometry3d goal = forward(robot, random_joints(robot, random));
        const IkResult ik = solve_ik(robot, goal, {.seed = random_joints(robot, random)});
        missed += ik.ok() && reaches(robot, ik.q, goal, true) ? 0 : 1;
      }
    }
    CHECK(missed == 0);
  }
}

TEST_CASE("three equal links folded back onto the shoulder keep the whole pose") {
  // The position says nothing about joints 1 and 2; the orientation does.
  const Robot arm = arm_of({{0, 0, 0, kRight}, {0, 0, 0.3, 0}, {0, 0, 0.3, 0}});
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = Eigen::Vector3d(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), kPi);
    const Isometry3d goal = forward(arm, q);
    const VectorXd seed = random_joints(arm, random);
    const IkResult pose = solve_ik(arm, goal, {.seed = seed});
    CHECK(pose.ok());
    CHECK(reaches(arm, pose.q, goal, true));
    // The position alone leaves the present values of both.
    const IkResult place = solve_ik(arm, goal, {.seed = seed, .task = IkTask::kPosition});
    CHECK(reaches(arm, place.q, goal, false));
    CHECK(std::abs(place.q[1] - seed[1]) < 1e-6);
  }
}

TEST_CASE("a link without length leaves a joint where it is, and the rest of the pose is exact") {
  const Robot plane = arm_of({{0, 0, 0.3, 0}, {0, 0.1, 0, 0}, {0, 0, 0.2, 0}});
  const VectorXd q = Eigen::Vector3d(0.4, -1.2, 0.9);
  ClosedSolutions solutions;
  REQUIRE(closed_form(plane).solve(forward(plane, q), Eigen::Vector3d(0.0, 0.7, 0.0), solutions) ==
          1);
  CHECK(solutions.free);
  CHECK(solutions.at[0].joints().isApprox(Eigen::Vector3d(0.4, 0.7, -1.0), 1e-12));
}

TEST_CASE("a solution next to a singularity is as exact as it says") {
  // Improving it once more would make it worse.
  Random random(46);
  for (int k = 0; k < 3'000; ++k) {
    const Robot robot(special_arm(random, 6));
    const VectorXd q = special_joints(random, robot);
    const Isometry3d goal = forward(robot, q);
    for (const double tolerance : {1e-6, 1e-9}) {
      ClosedSolutions solutions;
      closed_form(robot).solve(goal, VectorXd::Zero(6), solutions, tolerance);
      for (const ClosedSolution& s : solutions) {
        const Isometry3d reached = forward(robot, s.joints());
        CHECK((reached.translation() - goal.translation()).norm() <= 1.001 * tolerance);
        CHECK(angle_between(reached, goal) <= 1.001 * tolerance);
      }
    }
  }
}
