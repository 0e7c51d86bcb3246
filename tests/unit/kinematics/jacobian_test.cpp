#include "armlet/kinematics/jacobian.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"
#include "reference_samples.hpp"

using namespace armlet;

TEST_CASE("Jacobians of fourteen arms agree with other libraries") {
  reference::for_each_sample(
      [](const Robot& robot, const reference::Json& sample, const Eigen::VectorXd& q) {
        const Eigen::VectorXd qd = reference::vector_of(sample.at("qd"));
        const Eigen::MatrixXd J0 = reference::matrix_of(sample.at("J0"));
        const Eigen::MatrixXd Je = reference::matrix_of(sample.at("Je"));
        CHECK((jacobian(robot, q) - J0).cwiseAbs().maxCoeff() < 1e-10);
        CHECK((jacobian(robot, q, JacobianFrame::kTool) - Je).cwiseAbs().maxCoeff() < 1e-10);
        const Eigen::VectorXd bias = reference::vector_of(sample.at("Jdot_qd"));
        CHECK((jacobian_dot_qd(robot, q, qd) - bias).cwiseAbs().maxCoeff() < 1e-10);
      });
}

// Central differences with h = 1e-6 are good to about 1e-9: h^2 and rounding over h.
TEST_CASE("the Jacobian is the derivative of the tool pose") {
  Random random(1);
  constexpr double h = 1e-6;
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 100; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      const Jacobian J = jacobian(robot, q);
      for (int i = 0; i < robot.n(); ++i) {
        const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(robot.n(), i);
        const Vector6d change =
            pose_error(forward(robot, q - step), forward(robot, q + step)) / (2 * h);
        CHECK((J.col(i) - change).norm() < 1e-8);
      }
    }
  }
}

TEST_CASE("Jdot qd is the change of the Jacobian along the motion") {
  Random random(2);
  constexpr double h = 1e-6;
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 50; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      Eigen::VectorXd qd(robot.n());
      for (double& v : qd) v = random.uniform(-1, 1);
      const Vector6d expected =
          (jacobian(robot, q + h * qd) - jacobian(robot, q - h * qd)) * qd / (2 * h);
      CHECK((jacobian_dot_qd(robot, q, qd) - expected).norm() < 1e-7);
    }
  }
}

// As above, for every column and in all three axes.
TEST_CASE("the rate of the Jacobian is its derivative along the motion") {
  Random random(4);
  constexpr double h = 1e-6;
  for (int n = 1; n <= kMaxJoints; ++n) {
    for (int k = 0; k < 20; ++k) {
      const Robot robot = random_arm(random, n);
      const Eigen::VectorXd q = random_values(random, n);
      Eigen::VectorXd qd(n);
      for (double& v : qd) v = random.uniform(-1, 1);
      for (const JacobianFrame frame :
           {JacobianFrame::kWorld, JacobianFrame::kBase, JacobianFrame::kTool}) {
        const Jacobian rate = jacobian_rate(robot, q, qd, frame);
        const Jacobian change =
            (jacobian(robot, q + h * qd, frame) - jacobian(robot, q - h * qd, frame)) / (2 * h);
        CHECK((rate - change).cwiseAbs().maxCoeff() < 1e-6);
      }
      CHECK((jacobian_rate(robot, q, qd) * qd - jacobian_dot_qd(robot, q, qd)).norm() < 1e-11);
    }
  }
}

TEST_CASE("the frames differ by rotations of both halves") {
  Random random(3);
  const Robot robot = make_robot("puma560")->with_base(pose_from_rpy({1, 2, 3}, {0.3, -0.4, 0.5}));
  const Eigen::VectorXd q = random_joints(robot, random);
  const Jacobian J = jacobian(robot, q);
  const Eigen::Matrix3d R_world_tool = forward(robot, q).linear();
  for (int i = 0; i < 6; ++i) {
    const Vector6d in_tool = jacobian(robot, q, JacobianFrame::kTool).col(i);
    const Vector6d in_base = jacobian(robot, q, JacobianFrame::kBase).col(i);
    CHECK((rotate_twist(R_world_tool, in_tool) - J.col(i)).norm() < 1e-14);
    CHECK((rotate_twist(robot.T_world_base().linear(), in_base) - J.col(i)).norm() < 1e-14);
  }
  const Robot plain = robot.with_base(Eigen::Isometry3d::Identity());
  CHECK((jacobian(robot, q, JacobianFrame::kBase) - jacobian(plain, q)).norm() < 1e-14);
}

// forward() walks from the tool to the base, where other roundings happen.
TEST_CASE("pose and Jacobian in one pass are those of two passes") {
  const Robot robot = *make_robot("panda");
  Jacobian J;
  const Eigen::Isometry3d T = forward_and_jacobian(robot, robot.home(), J);
  CHECK((T.matrix() - forward(robot, robot.home()).matrix()).norm() < 1e-15);
  CHECK(J == jacobian(robot, robot.home()));
}

TEST_CASE("vectors of a wrong size are refused") {
  const Robot robot = *make_robot("panda");
  CHECK_THROWS_AS(jacobian(robot, Eigen::VectorXd::Zero(6)), ArgumentError);
  CHECK_THROWS_AS(jacobian_dot_qd(robot, robot.home(), Eigen::VectorXd::Zero(6)), ArgumentError);
  CHECK_THROWS_AS(jacobian_rate(robot, robot.home(), Eigen::VectorXd::Zero(6)), ArgumentError);
  CHECK_THROWS_AS(jacobian_rate(robot, robot.home(), Eigen::VectorXd::Constant(7, NAN)),
                  ArgumentError);
}
