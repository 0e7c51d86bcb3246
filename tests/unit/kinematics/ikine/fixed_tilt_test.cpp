#include "armlet/kinematics/fixed_tilt.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Isometry3d any_position(Random& random) {
  return pose_from_rpy({random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.2},
                       {random.uniform(-3, 3), random.uniform(-1.5, 1.5), random.uniform(-3, 3)});
}

// Axes that are parallel, upright or along a line by chance, as those of real arms are.
Robot any_arm(Random& random) {
  Robot robot = random_arm(random, 1 + static_cast<int>(random.below(7)));
  if (random.below(2) == 0) {
    const auto& names = catalog_names();
    robot = *make_robot(names[random.below(names.size())]);
  }
  if (random.below(2) == 0) robot = robot.with_base(any_position(random));
  if (random.below(2) == 0) robot = robot.with_tool_point(any_position(random));
  return robot;
}

Robot gantry() {
  RobotSpec spec;
  const auto slide = [](double theta, double alpha) {
    Joint joint;
    joint.kind = JointKind::kPrismatic;
    joint.dh = {theta, 0, 0, alpha};
    joint.lower = -1.0;
    joint.upper = 1.0;
    return joint;
  };
  Joint turn;
  turn.dh = {0, 0, 0, kPi};
  spec.joints = {slide(0, kPi / 2), slide(kPi / 2, kPi / 2), slide(0, 0), turn};
  // The third slide is vertical.
  const Robot lying(spec);
  const Vector3d axis = link_frame(lying, VectorXd::Zero(4), 2).linear().col(2);
  const Vector3d normal = axis.cross(Vector3d::UnitZ());
  const double angle = std::atan2(normal.norm(), axis.z());
  spec.T_world_base =
      make_pose(Eigen::AngleAxisd(angle, normal.normalized()).toRotationMatrix(), Vector3d::Zero());
  return Robot(spec);
}

}  // namespace

TEST_CASE("an arm reaches the pose where it stands, whatever its base and its tool") {
  Random random(53);
  int missed = 0, moved = 0, tilted = 0;
  for (int k = 0; k < 4'000; ++k) {
    const Robot robot = any_arm(random);
    const VectorXd q = random_joints(robot, random);
    const Isometry3d here = forward(robot, q);
    const auto task = frame_task(robot, here);
    tilted += fixed_tilt(robot) && task == IkTask::kPose ? 1 : 0;
    if (!task) {
      ++missed;
      continue;
    }
    const IkResult ik = solve_ik(robot, here, {.seed = q, .task = *task});
    missed += ik.ok() && within_limits(robot, ik.q, 0.0) ? 0 : 1;
    moved += (ik.q - q).cwiseAbs().maxCoeff() <= 1e-6 ? 0 : 1;
    // From elsewhere too.
    if (k % 4 == 0) {
      const VectorXd seed = random_joints(robot, random);
      const auto other = solve_ik(robot, here, {.seed = seed, .task = *task, .diagnose = false});
      missed += other.ok() ? 0 : 1;
    }
  }
  CHECK(missed == 0);
  CHECK(moved == 0);
  CHECK(tilted > 50);
}

TEST_CASE("the tilt that no joint changes is that of every pose, and no other arm has one") {
  Random random(54);
  for (int k = 0; k < 300; ++k) {
    const Robot robot = any_arm(random);
    const auto up = fixed_tilt(robot);
    double most = 0.0;
    const Vector3d first = forward(robot, random_joints(robot, random)).linear().row(2);
    for (int j = 0; j < 5; ++j) {
      const Vector3d other = forward(robot, random_joints(robot, random)).linear().row(2);
      most = std::max(most, (other - first).norm());
    }
    CHECK(up.has_value() == (most < 1e-7));
    if (up) CHECK((*up - first).norm() < 1e-7);
  }
}

TEST_CASE("an upright frame asks a tool that points down for its position and its rotation") {
  for (const Robot& robot : {*make_robot("scara"), gantry()}) {
    REQUIRE(fixed_tilt(robot));
    const VectorXd q = VectorXd::Constant(4, 0.1);
    const Isometry3d here = forward(robot, q);
    REQUIRE(here.linear()(2, 2) == doctest::Approx(-1.0));
    const double heading = std::atan2(here.linear()(1, 0), here.linear()(0, 0));
    const Isometry3d frame = make_pose(rot_z(heading), here.translation());
    REQUIRE(frame_task(robot, frame) == IkTask::kHeading);
    const IkResult ik = solve_ik(robot, frame, {.seed = q, .task = IkTask::kHeading});
    REQUIRE(ik.ok());
    CHECK((ik.q - q).cwiseAbs().maxCoeff() < 1e-9);
    CHECK(with_heading_of(robot, frame, q).isApprox(here, 1e-12));
    // Rotation is exact to 1e-6 rad, here as everywhere.
    CHECK(frame_task(robot, frame * make_pose(rot_x(0.9e-6), Vector3d::Zero())).has_value());
    CHECK_FALSE(frame_task(robot, frame * make_pose(rot_x(1.1e-6), Vector3d::Zero())).has_value());
    CHECK(tilt_error(robot, frame * make_pose(rot_x(0.001), Vector3d::Zero())) ==
          doctest::Approx(kPi - 0.001));
  }
}

TEST_CASE("a tilted tool takes the frames that lean like it, and no upright ones") {
  const Isometry3d T_flange_tool = make_pose(rot_x(kPi / 6), {0, 0, 0.1});
  const Robot robot = make_robot("scara")->with_tool_point(T_flange_tool);
  const VectorXd q = VectorXd::Constant(4, 0.1);
  const Isometry3d here = forward(robot, q);
  CHECK(frame_task(robot, here) == IkTask::kPose);
  CHECK_FALSE(frame_task(robot, make_translation(here.translation())).has_value());
  // The same angle from the vertical, to another side.
  CHECK_FALSE(frame_task(robot, here * make_pose(rot_z(0.1), Vector3d::Zero())).has_value());
  CHECK(tilt_error(robot, here * make_pose(rot_y(0.2), Vector3d::Zero())) ==
        doctest::Approx(std::acos(std::cos(kPi / 6) * (std::cos(0.2) * std::cos(kPi / 6)) +
                                  std::sin(kPi / 6) * std::sin(kPi / 6))));
  CHECK(frame_task(*make_robot("puma560"), here) == IkTask::kPose);
}
