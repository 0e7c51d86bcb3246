#include "armlet/kinematics/null_space.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

TEST_CASE("the projector keeps the tool still, and leaves alone what already does") {
  Random random(1);
  for (const std::string_view name : {"pa10", "panda"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 100; ++k) {
      const VectorXd q = random_joints(robot, random);
      const Eigen::MatrixXd P = null_space_projector(robot, q);
      CHECK((jacobian(robot, q) * P).cwiseAbs().maxCoeff() < 1e-12);
      CHECK((P * P - P).cwiseAbs().maxCoeff() < 1e-12);
      CHECK(P.trace() == doctest::Approx(1.0));  // seven joints, six rows
    }
  }
}

TEST_CASE("a square arm has no freedom left, and one for each row that does not count") {
  const Robot robot = *make_robot("puma560");
  Random random(2);
  const VectorXd q = random_joints(robot, random);
  CHECK(null_space_projector(robot, q).cwiseAbs().maxCoeff() < 1e-9);
  const TaskRows roll_free{.counts = {true, true, true, true, true, false},
                           .axes = JacobianFrame::kTool};
  CHECK(null_space_projector(robot, q, roll_free).trace() == doctest::Approx(1.0));
  const TaskRows place{.counts = {true, true, true, false, false, false}};
  CHECK(null_space_projector(robot, q, place).trace() == doctest::Approx(3.0));
}

TEST_CASE("ten seconds of self-motion in steps of 1 ms move the tool by less than a micrometre") {
  const Robot robot = *make_robot("pa10");
  VectorXd q(7);
  q << 0.2, 0.6, 0.3, 1.2, -0.4, 0.9, 0.1;
  const Isometry3d T = forward(robot, q);
  double worst = 0.0, travelled = 0.0;
  for (int k = 0; k < 10'000; ++k) {
    const VectorXd wished = VectorXd::Constant(7, 0.5);
    const VectorXd next = self_motion_step(robot, T, q, wished, 1e-3);
    travelled += (next - q).norm();
    q = next;
    worst = std::max(worst, (forward(robot, q).translation() - T.translation()).norm());
    worst = std::max(worst, angle_between(forward(robot, q), T));
  }
  CHECK(travelled > 0.1);
  CHECK(worst < 1e-6);
}

TEST_CASE("gradients are those of the values") {
  const Robot robot = *make_robot("panda");
  Random random(3);
  for (const Posture posture : {Posture::kMidRange, Posture::kManipulability}) {
    const VectorXd q = random_joints(robot, random);
    const VectorXd gradient = posture_gradient(robot, q, posture);
    for (int i = 0; i < 7; ++i) {
      VectorXd above = q, below = q;
      above[i] += 1e-4;
      below[i] -= 1e-4;
      const double slope =
          (posture_value(robot, above, posture) - posture_value(robot, below, posture)) / 2e-4;
      CHECK(gradient[i] == doctest::Approx(slope).epsilon(1e-4).scale(1.0));
    }
  }
}

TEST_CASE("a better posture leaves the tool where it is and the joints within their limits") {
  Random random(4);
  for (const std::string_view name : {"pa10", "panda"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (const Posture posture : {Posture::kMidRange, Posture::kManipulability}) {
      int better = 0;
      for (int k = 0; k < 10; ++k) {
        const VectorXd q = random_joints(robot, random);
        const VectorXd improved = improve_posture(robot, q, posture);
        CHECK(posture_value(robot, improved, posture) >= posture_value(robot, q, posture));
        CHECK(within_limits(robot, improved, 0.0));
        const Isometry3d T = forward(robot, q), after = forward(robot, improved);
        CHECK((after.translation() - T.translation()).norm() < 2e-9);
        CHECK(angle_between(after, T) < 2e-9);
        better += posture_value(robot, improved, posture) > posture_value(robot, q, posture);
      }
      CHECK(better >= 8);
    }
  }
}

TEST_CASE("a joint at its speed limit is held there and the others make up for it") {
  const Robot robot = *make_robot("pa10");
  VectorXd q(7);
  q << 0.2, 0.6, 0.3, 1.2, -0.4, 0.9, 0.1;
  const Vector6d twist = (Vector6d() << 0.1, 0.05, -0.05, 0.1, 0.0, 0.1).finished();
  const VectorXd none = VectorXd::Zero(7);
  const VectorXd wide = VectorXd::Constant(7, 100.0);
  const BoundedSpeeds plain = bounded_joint_speeds(robot, q, twist, none, -wide, wide);
  CHECK(plain.reached);
  CHECK(plain.saturated.empty());
  // The elbow's speed follows from the distance of the wrist, the others can stand in for each
  // other.
  VectorXd replaceable = plain.qd.cwiseAbs();
  replaceable[3] = 0.0;
  Eigen::Index fastest = 0;
  replaceable.maxCoeff(&fastest);
  VectorXd bound = wide;
  bound[fastest] = 0.8 * std::abs(plain.qd[fastest]);
  const BoundedSpeeds held = bounded_joint_speeds(robot, q, twist, none, -bound, bound);
  CHECK(held.reached);
  CHECK(held.saturated == std::vector<int>{static_cast<int>(fastest)});
  CHECK(std::abs(held.qd[fastest]) == doctest::Approx(bound[fastest]));
  CHECK((jacobian(robot, q) * held.qd - twist).cwiseAbs().maxCoeff() < 1e-9);
  const VectorXd narrow = VectorXd::Constant(7, 1e-3);
  CHECK_FALSE(bounded_joint_speeds(robot, q, twist, none, -narrow, narrow).reached);
}
