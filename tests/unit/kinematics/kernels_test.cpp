#include "kinematics/forward/kernels.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

// What every kernel writes for one configuration, one after the other.
std::vector<double> all_results(const Robot& robot, const Eigen::VectorXd& q, std::size_t index) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  std::vector<double> results(3 * 16 + 16 * n + 2 * 6 * n);
  double* next = results.data();
  const WalkPlan& plan = robot.walk_plan();
  kPoseKernels[index](plan, q.data(), next);
  next += 16;
  kFramesKernels[index](plan, q.data(), next + 16, next);
  next += 16 + 16 * n;
  kPoseAndJacobianKernels[index](plan, q.data(), next + 16, next);
  next += 16 + 6 * n;
  kJacobianKernels[index](plan, q.data(), next);
  return results;
}

}  // namespace

TEST_CASE("a kernel for its number of joints gives the bits of the one for any number") {
  Random random(1);
  for (int n = 1; n <= 8; ++n) {
    CAPTURE(n);
    bool same = true;
    for (int arm = 0; arm < 200; ++arm) {
      const Robot robot = random_arm(random, n);
      const Eigen::VectorXd q = random_values(random, n);
      const std::vector<double> own = all_results(robot, q, static_cast<std::size_t>(n));
      const std::vector<double> any = all_results(robot, q, 0);
      for (std::size_t i = 0; i < own.size(); ++i) same = same && same_bits(own[i], any[i]);
    }
    CHECK(same);
  }
}

// Twelve steps of a few roundings each, of lengths up to five metres.
TEST_CASE("any chain is the product of its rows, in whichever direction it is traversed") {
  Random random(2);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    double worst = 0.0;
    for (int arm = 0; arm < 100; ++arm) {
      const Robot robot = random_arm(random, n);
      const Eigen::VectorXd q = random_values(random, n);
      std::vector<Eigen::Isometry3d> frames(static_cast<std::size_t>(n));
      const Eigen::Isometry3d outward = link_frames(robot, q, frames);
      Eigen::Isometry3d T = robot.T_world_base();
      for (int i = 0; i < n; ++i) {
        DhRow row = robot.joint(i).dh;
        (robot.is_revolute(i) ? row.theta : row.d) += q[i];
        T = T * dh_pose(robot.spec().convention, row);
        const Eigen::Isometry3d& frame = frames[static_cast<std::size_t>(i)];
        worst = std::max(worst, (frame.matrix() - T.matrix()).cwiseAbs().maxCoeff());
      }
      T = T * robot.T_flange_tool();
      worst = std::max(worst, (outward.matrix() - T.matrix()).cwiseAbs().maxCoeff());
      worst = std::max(worst, (forward(robot, q).matrix() - T.matrix()).cwiseAbs().maxCoeff());
    }
    CHECK(worst < 1e-13);
  }
}

TEST_CASE("angles that the lanes leave open are as exact as others") {
  Random random(3);
  for (int n = 1; n <= kMaxJoints; ++n) {
    const Robot robot = random_arm(random, n);
    Eigen::VectorXd q = random_values(random, n);
    const Eigen::VectorXd turns = Eigen::VectorXd::Constant(n, 2.0 * 3.14159265358979323846);
    for (int i = 0; i < n; ++i) {
      if (!robot.is_revolute(i)) continue;
      Eigen::VectorXd far = q;
      far[i] = 1e9 * turns[i];
      Eigen::VectorXd near = q;
      near[i] = std::remainder(far[i], turns[i]);
      // 1e9 times the rounding error of the constant 2 pi.
      CHECK((forward(robot, far).matrix() - forward(robot, near).matrix()).norm() < 1e-5);
    }
  }
}

TEST_CASE("a joint value that is not finite is refused by the number of its joint") {
  Random random(4);
  for (int n = 1; n <= kMaxJoints; ++n) {
    const Robot robot = random_arm(random, n);
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      for (int i = 0; i < n; ++i) {
        Eigen::VectorXd q = random_values(random, n);
        q[i] = wrong;
        CHECK_THROWS_WITH_AS(forward(robot, q),
                             doctest::Contains(("joint " + std::to_string(i + 1) + " is").c_str()),
                             ArgumentError);
        CHECK_THROWS_AS(jacobian(robot, q), ArgumentError);
        CHECK_THROWS_AS(link_frames(robot, q), ArgumentError);
      }
    }
  }
}
