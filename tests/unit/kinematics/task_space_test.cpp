#include "armlet/kinematics/task_space.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Joint joint(JointKind kind, double theta, double d, double a, double alpha) {
  Joint out;
  out.kind = kind;
  out.dh = {theta, d, a, alpha};
  out.lower = kind == JointKind::kRevolute ? -2.5 : 0.0;
  out.upper = kind == JointKind::kRevolute ? 2.5 : 0.4;
  return out;
}
constexpr JointKind R = JointKind::kRevolute, P = JointKind::kPrismatic;

Robot arm(std::vector<Joint> joints) {
  RobotSpec spec;
  spec.joints = std::move(joints);
  return Robot(std::move(spec));
}

// A waist, then links in a vertical plane that stands `offset` beside the waist's axis.
Robot elbow_arm(double offset, int pitches, bool rolls) {
  std::vector<Joint> joints = {joint(R, 0, 0.4, 0.02, kPi / 2)};
  for (int i = 0; i + 1 < pitches; ++i)
    joints.push_back(joint(R, 0, i == 0 ? offset : 0.0, 0.3, 0));
  joints.push_back(joint(R, kPi / 2, 0, 0, kPi / 2));
  if (rolls) joints.push_back(joint(R, 0, 0.15, 0, 0));
  Robot robot = arm(std::move(joints));
  return rolls ? robot : robot.with_tool_point(make_translation({0, 0, 0.15}));
}

VectorXd random_joints(Random& random, const Robot& robot) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
  return q;
}

// Pitch and roll by their definition: the heading of the point from the waist's axis at (x, y),
// where the plane of the tool is not beside it.
std::vector<double> coordinates(const Isometry3d& T, const Vector3d& axis, bool rolls) {
  const Vector3d p = T.translation();
  const double heading = std::atan2(p.y() - axis.y(), p.x() - axis.x());
  const Matrix3d L = rot_z(-heading) * T.linear();
  const double pitch = std::atan2(L(2, 2), L(0, 2));
  std::vector<double> out = {p.x(), p.y(), p.z(), pitch};
  // The horizontal side of the tool against its own y axis.
  if (rolls) out.push_back(std::atan2(L(1, 0), L(1, 1)));
  return out;
}

double apart(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("arms of every build control as many coordinates as they have freedoms") {
  CHECK(task_space(*make_robot("scorbot")) == TaskSpace::kPitchRoll);
  CHECK(task_space(*make_robot("scara")) == TaskSpace::kHeading);
  const Isometry3d level = Isometry3d::Identity();
  CHECK(task_space(make_robot("planar2")->with_base(level)) == TaskSpace::kPlanePosition);
  // As it comes it stands upright.
  CHECK(task_space(*make_robot("planar2")) == TaskSpace::kOther);
  CHECK(task_space(*make_robot("planar3")) == TaskSpace::kPlane);
  for (const char* name : {"puma560", "ur5", "arm7", "pa10"}) {
    CAPTURE(std::string(name));
    CHECK(task_space(*make_robot(name)) == TaskSpace::kPose);
  }
  CHECK(task_space(elbow_arm(0.0, 3, true)) == TaskSpace::kPitchRoll);
  CHECK(task_space(elbow_arm(0.1, 3, true)) == TaskSpace::kPitchRoll);
  CHECK(task_space(elbow_arm(0.0, 3, false)) == TaskSpace::kPitch);
  CHECK(task_space(elbow_arm(0.0, 2, false)) == TaskSpace::kPosition);
  // A waist on a column with a slide: also without two joints that pitch.
  CHECK(task_space(arm({joint(R, 0, 0, 0, 0), joint(P, 0, 0, 0, -kPi / 2),
                        joint(P, 0, 0, 0, 0)})) == TaskSpace::kPosition);
  CHECK(task_space(arm({joint(R, 0, 0, 0.3, 0)})) == TaskSpace::kOther);
  // Four joints in a level plane: one to spare.
  CHECK(task_space(arm({joint(R, 0, 0, 0.3, 0), joint(R, 0, 0, 0.3, 0), joint(R, 0, 0, 0.2, 0),
                        joint(R, 0, 0, 0.1, 0)})) == TaskSpace::kPlane);
}

TEST_CASE("a base that leans leaves an arm no coordinates of its own, one that is placed does") {
  const Isometry3d placed = pose_from_rpy({0.3, -0.2, 0.5}, {0, 0, 0.7});
  const Isometry3d leaning = pose_from_rpy({0.3, -0.2, 0.5}, {0.4, 0, 0.7});
  for (const char* name : {"scorbot", "scara", "planar3", "planar2"}) {
    CAPTURE(std::string(name));
    const auto robot = make_robot(name);
    const TaskSpace level = task_space(robot->with_base(Isometry3d::Identity()));
    CHECK(level != TaskSpace::kOther);
    CHECK(task_space(robot->with_base(placed)) == level);
    CHECK(task_space(robot->with_base(leaning)) == TaskSpace::kOther);
  }
  CHECK(task_space(make_robot("ur5")->with_base(leaning)) == TaskSpace::kPose);
}

TEST_CASE("pitch and roll of a position that an arm reaches give it back") {
  Random random(71);
  const Isometry3d base = pose_from_rpy({0.3, -0.2, 0.5}, {0, 0, 0.7});
  for (const bool rolls : {true, false}) {
    for (const Robot& plain :
         {elbow_arm(0.0, 3, rolls), elbow_arm(0.0, 3, rolls).with_base(base)}) {
      for (int k = 0; k < 200; ++k) {
        const VectorXd q = random_joints(random, plain);
        const Isometry3d T = forward(plain, q);
        // Bent backwards over its waist, a tool that cannot roll shows its other side.
        const Vector3d out = plain.T_world_base().linear() * rot_z(q[0]).col(0);
        const Vector3d reach = T.translation() - plain.T_world_base().translation();
        if (!rolls && out.dot(reach) < 0.0) continue;
        const auto values = coordinates(T, plain.T_world_base().translation(), rolls);
        const auto again = pose_of_coordinates(plain, values);
        REQUIRE(again);
        CHECK(apart(*again, T) < 1e-9);
      }
    }
  }
}

TEST_CASE("a tool plane beside the axis is found by its distance") {
  Random random(72);
  const Robot robot = elbow_arm(0.1, 3, true);
  int forwards = 0;
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_joints(random, robot);
    const Isometry3d T = forward(robot, q);
    // The plane rotates with the first joint: reaching forwards along its x axis.
    const Vector3d out(std::cos(q[0]), std::sin(q[0]), 0.0);
    if (out.dot(T.translation()) < 0.0) continue;
    ++forwards;
    const Matrix3d L = rot_z(-q[0]) * T.linear();
    const std::vector<double> values = {T.translation().x(), T.translation().y(),
                                        T.translation().z(), std::atan2(L(2, 2), L(0, 2)),
                                        std::atan2(L(1, 0), L(1, 1))};
    const auto again = pose_of_coordinates(robot, values);
    REQUIRE(again);
    CHECK(apart(*again, T) < 1e-9);
  }
  CHECK(forwards > 50);
  CHECK_FALSE(pose_of_coordinates(robot, std::vector<double>{0.01, 0.02, 0.3, 0.0, 0.0}));
}

TEST_CASE("straight down is -90 deg, straight out 0") {
  const auto robot = make_robot("scorbot");
  const auto down = pose_of_coordinates(*robot, std::vector<double>{0.2, 0.1, 0.3, -kPi / 2, 0.4});
  REQUIRE(down);
  CHECK((down->linear().col(2) - Vector3d(0, 0, -1)).norm() < 1e-12);
  const auto out = pose_of_coordinates(*robot, std::vector<double>{0.2, 0.1, 0.3, 0.0, 0.0});
  REQUIRE(out);
  CHECK((out->linear().col(2) - Vector3d(0.2, 0.1, 0).normalized()).norm() < 1e-12);
  CHECK(std::abs(out->linear()(2, 1)) < 1e-12);
}

TEST_CASE("another number of values means nothing") {
  for (const char* name : {"scorbot", "scara", "planar3", "planar2", "ur5"}) {
    CAPTURE(std::string(name));
    const Robot robot = make_robot(name)->with_base(Isometry3d::Identity());
    for (std::size_t n = 0; n < 8; ++n) {
      const bool fits = static_cast<int>(n) == coordinate_count(task_space(robot));
      CHECK(pose_of_coordinates(robot, std::vector<double>(n, 0.1)).has_value() == fits);
    }
  }
}
