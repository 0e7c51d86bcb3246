// Arms with joints that copy others: poses, Jacobians and inverse kinematics.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "armlet/kinematics/batch.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/kinematics/task_space.hpp"
#include "armlet/model/serial_arm.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

Robot arm_of(const Mechanism& tree) {
  const Result<RobotSpec> spec = serial_arm(tree, "tool");
  REQUIRE(spec.ok());
  return Robot(*spec);
}

Mechanism random_tree(Random& random) {
  return random_coupled_chain(random, 1 + static_cast<int>(random.below(5)),
                              1 + static_cast<int>(random.below(3)));
}

// A palletiser: joints rotate the column, the rear arm and the fore arm, whose angles are those
// from the horizontal, for after each a link turns back as far; the last joint rotates the tool.
RobotSpec palletiser() {
  RobotSpec spec{.name = "palletiser", .convention = DhConvention::kModified};
  constexpr double kRight = std::numbers::pi / 2;
  spec.joints.resize(6);
  spec.joints[0].dh = {0.0, 0.1, 0.0, 0.0};
  spec.joints[1].dh = {0.0, 0.0, 0.05, -kRight};
  spec.joints[2].dh = {0.0, 0.0, 0.2, 0.0};
  spec.joints[3].dh = {0.0, 0.0, 0.0, 0.0};
  spec.joints[4].dh = {0.0, 0.0, 0.25, 0.0};
  spec.joints[5].dh = {0.0, 0.03, 0.02, -kRight};
  spec.joints[2].drive = {.of = 1, .ratio = -1.0};
  spec.joints[4].drive = {.of = 3, .ratio = -1.0};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
    spec.joints[k].lower = -1.4;
    spec.joints[k].upper = 1.4;
  }
  return spec;
}

}  // namespace

TEST_CASE("poses and Jacobians of an arm with copying joints are those of its tree") {
  Random random(8001);
  for (int k = 0; k < 200; ++k) {
    const Mechanism tree = random_tree(random);
    const Robot arm = arm_of(tree);
    const VectorXd q = random_values(random, arm.n()), qd = random_rates(random, arm.n());
    const Tip& tip = tree.tip("tool");
    const Eigen::Isometry3d T = tip_pose(tree, q, tip);
    CHECK((forward(arm, q).matrix() - T.matrix()).norm() < 1e-11);
    const Jacobian J = jacobian(arm, q);
    REQUIRE(J.cols() == arm.n());
    CHECK((J - tip_jacobian(tree, q, tip)).norm() < 1e-11);
    constexpr double kStep = 1e-6;
    const VectorXd below = q - kStep * qd, above = q + kStep * qd;
    const Vector6d change = pose_error(forward(arm, below), forward(arm, above)) / (2 * kStep);
    CHECK((J * qd - change).norm() < 1e-7 * (1.0 + change.norm()));
    Jacobian both;
    CHECK((forward_and_jacobian(arm, q, both).matrix() - T.matrix()).norm() < 1e-11);
    CHECK((both - J).norm() < 1e-12);
    for (const JacobianFrame frame :
         {JacobianFrame::kWorld, JacobianFrame::kBase, JacobianFrame::kTool}) {
      const Jacobian rate =
          (jacobian(arm, above, frame) - jacobian(arm, below, frame)) / (2 * kStep);
      CHECK((jacobian_rate(arm, q, qd, frame) - rate).norm() < 1e-6 * (1.0 + rate.norm()));
    }
    CHECK((jacobian_dot_qd(arm, q, qd) - jacobian_rate(arm, q, qd) * qd).norm() < 1e-9);
  }
}

TEST_CASE("batches of an arm with copying joints are its poses and Jacobians") {
  Random random(8002);
  using Lanes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (int k = 0; k < 30; ++k) {
    const Robot arm = arm_of(random_tree(random));
    for (const Eigen::Index count : {0, 1, 5, 16}) {
      Lanes q(arm.n(), count), poses(12, count), J(6 * arm.n(), count);
      for (Eigen::Index c = 0; c < count; ++c) q.col(c) = random_values(random, arm.n());
      const auto span = [](Lanes& m) {
        return std::span(m.data(), static_cast<std::size_t>(m.size()));
      };
      forward_batch(arm, span(q), span(poses));
      jacobian_batch(arm, span(q), span(J));
      for (Eigen::Index c = 0; c < count; ++c) {
        const VectorXd at = q.col(c);
        const Eigen::Matrix<double, 3, 4> T = forward(arm, at).matrix().topRows<3>();
        CHECK((Eigen::Map<const Eigen::Matrix<double, 12, 1>>(T.data()) - poses.col(c)).norm() <
              1e-11);
        const Jacobian expected = jacobian(arm, at);
        CHECK((Eigen::Map<const VectorXd>(expected.data(), expected.size()) - J.col(c)).norm() <
              1e-11);
      }
    }
  }
}

TEST_CASE("inverse kinematics brings an arm with copying joints back to a pose") {
  Random random(8003);
  int found = 0, tried = 0;
  for (int k = 0; k < 60; ++k) {
    const Robot arm = arm_of(random_coupled_chain(random, 3 + static_cast<int>(random.below(4)),
                                                  1 + static_cast<int>(random.below(3))));
    CHECK_FALSE(closed_form(arm).exists());
    const VectorXd q = random_joints(arm, random);
    const Eigen::Isometry3d T = forward(arm, q);
    const IkResult near = solve_ik(arm, T, {.seed = q});
    CHECK(near.ok());
    const IkResult result = solve_ik(arm, T, {.seed = arm.home()});
    ++tried;
    if (!result.ok()) continue;
    ++found;
    CHECK((forward(arm, result.q).matrix() - T.matrix()).norm() < 1e-5);
    CHECK((result.q.array() >= arm.lower().array() - 1e-9).all());
    CHECK((result.q.array() <= arm.upper().array() + 1e-9).all());
  }
  MESSAGE("found " << found << " of " << tried);
  CHECK(found >= tried * 9 / 10);
}

TEST_CASE("a joint whose copy goes half as far is elsewhere after a revolution") {
  RobotSpec spec = palletiser();
  // The last row rotates with the first one, which has two revolutions.
  spec.joints[5].drive = {.of = 0, .ratio = 1.0};
  for (const double ratio : {1.0, 0.5}) {
    spec.joints[5].drive.ratio = ratio;
    const Robot arm(spec);
    REQUIRE(arm.n() == 3);
    const Eigen::Vector3d q(-0.3, 0.1, 0.2), near(6.0, 0.1, 0.2);
    const Eigen::Isometry3d T = forward(arm, q);
    const IkResult result = solve_ik(arm, T, {.seed = near});
    REQUIRE(result.ok());
    CHECK((forward(arm, result.q).matrix() - T.matrix()).norm() < 1e-5);
    // With a whole ratio the nearest solution is a revolution further, with half of one it is not.
    CHECK((result.q[0] > 3.0) == (ratio == 1.0));
    CHECK((wrap_near(arm, q, near)[0] > 3.0) == (ratio == 1.0));
  }
}

TEST_CASE("a palletiser keeps its tool upright, and reaches where its formulas say") {
  const Robot arm(palletiser());
  REQUIRE(arm.n() == 4);
  CHECK(fixed_tilt(arm).has_value());
  CHECK(task_space(arm) == TaskSpace::kHeading);
  CHECK_FALSE(fixed_tilt(arm.uncoupled()).has_value());
  Random random(8004);
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = random_joints(arm, random);
    // Two bars in a vertical plane, each at its own angle below the horizontal.
    const double out = 0.05 + 0.2 * std::cos(q[1]) + 0.25 * std::cos(q[2]) + 0.02,
                 height = 0.1 - 0.2 * std::sin(q[1]) - 0.25 * std::sin(q[2]) - 0.03;
    const Eigen::Isometry3d T = forward(arm, q);
    const Eigen::Vector3d p(out * std::cos(q[0]), out * std::sin(q[0]), height);
    CHECK((T.translation() - p).norm() < 1e-12);
    CHECK(T.linear()(2, 2) == doctest::Approx(-1.0).epsilon(1e-12));
    const IkResult result = solve_ik(arm, T, {.seed = arm.home()});
    REQUIRE(result.ok());
    CHECK((forward(arm, result.q).matrix() - T.matrix()).norm() < 1e-5);
  }
}
