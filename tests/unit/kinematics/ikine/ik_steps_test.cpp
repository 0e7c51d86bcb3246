#include "kinematics/ik/ik_steps.hpp"

#include <doctest/doctest.h>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/rotation.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

using Matrix = Eigen::MatrixXd;

NormalEquations normal_of(const Matrix& A, const Eigen::VectorXd& b) {
  NormalEquations normal;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    for (Eigen::Index k = 0; k <= i; ++k) normal.A[i][k] = A(i, k);
    normal.b[i] = b[i];
  }
  return normal;
}

Eigen::VectorXd step_of(const Matrix& A, const Eigen::VectorXd& b, double damping,
                        std::size_t kernel) {
  Eigen::VectorXd step(b.size());
  kStepKernels[kernel](static_cast<int>(b.size()), normal_of(A, b), damping, step.data());
  return step;
}

Matrix random_matrix(Random& random, int rows, int columns) {
  Matrix M(rows, columns);
  for (double& value : M.reshaped()) value = random.uniform(-1.0, 1.0);
  return M;
}

IkIterate iterate_at(const Robot& robot, const Eigen::VectorXd& q, const Eigen::Isometry3d& goal,
                     std::size_t kernel) {
  IkIterate at;
  const Eigen::Matrix3d R = goal.linear();
  const Eigen::Vector3d p = goal.translation();
  kIterationKernels[kernel](robot.walk_plan(), q.data(), p.data(), R.data(), 0.1, at);
  return at;
}

}  // namespace

TEST_CASE("a step solves the damped normal equations") {
  Random random(1);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    double worst = 0.0;
    bool same = true;
    for (int k = 0; k < 200; ++k) {
      const Matrix J = random_matrix(random, n + 2, n);
      const Matrix A = J.transpose() * J;
      const Eigen::VectorXd b = random_matrix(random, n, 1);
      const double damping = random.uniform(1e-3, 0.1);
      const Eigen::VectorXd step = step_of(A, b, damping, n < 9 ? n : 0);
      same = same && step == step_of(A, b, damping, 0);
      worst = std::max(worst, (A * step + damping * step - b).cwiseAbs().maxCoeff());
    }
    CHECK(same);
    CHECK(worst < 1e-12);
  }
}

// The columns of one joint are those of another, or none: of the two one moves.
TEST_CASE("a step of a singular arm leaves out the joints that others stand in for") {
  Random random(2);
  for (int n = 2; n <= 8; ++n) {
    CAPTURE(n);
    double worst = 0.0, largest = 0.0;
    for (int k = 0; k < 200; ++k) {
      Matrix J = random_matrix(random, n, n);
      const auto twin = static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(n - 1)));
      if (k % 2 == 0)
        J.col(n - 1) = J.col(twin);
      else
        J.col(twin).setZero();
      const Eigen::VectorXd wanted = J * random_matrix(random, n, 1);
      const Eigen::VectorXd step =
          step_of(J.transpose() * J, J.transpose() * wanted, 0.0, static_cast<std::size_t>(n));
      const double condition = singular_values(J).s[n - 2];
      if (condition < 0.01) continue;
      worst = std::max(worst, (J * step - wanted).cwiseAbs().maxCoeff());
      largest = std::max(largest, step.cwiseAbs().maxCoeff());
    }
    CHECK(worst < 1e-8);
    CHECK(largest < 1e4);
  }
}

TEST_CASE("an iteration's kernel has the error, the Jacobian and the step of its configuration") {
  Random random(3);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    double error = 0.0, slope = 0.0, rest = 0.0, size = 0.0;
    bool same = true;
    for (int k = 0; k < 100; ++k) {
      const Robot robot = random_arm(random, n);
      const Eigen::VectorXd q = random_values(random, n);
      const Eigen::Isometry3d goal =
          forward(robot, k % 2 == 0 ? Eigen::VectorXd(q.array() + 1e-4) : random_values(random, n));
      const IkIterate at = iterate_at(robot, q, goal, n < 9 ? static_cast<std::size_t>(n) : 0);
      const IkIterate any = iterate_at(robot, q, goal, 0);
      Jacobian J;
      const Eigen::Isometry3d T = forward_and_jacobian(robot, q, J);
      const Eigen::Vector3d turn = rotation_log(goal.linear() * T.linear().transpose());
      const Eigen::Map<const Vector6d> e(at.error.data());
      const Matrix own = Eigen::Map<const Matrix>(at.J[0].data(), 6, n);
      error = std::max(error, (e.head<3>() - goal.translation() + T.translation()).norm());
      if (k % 2 == 0 || turn.norm() > 1.6)  // else only good to half a percent
        error = std::max(error, (e.tail<3>() - turn).norm() / (1.0 + turn.squaredNorm()));
      slope = std::max(slope, (own - J).cwiseAbs().maxCoeff());
      size = std::max({size, std::abs(at.position - e.head<3>().norm()),
                       std::abs(at.rotation - e.tail<3>().norm()),
                       std::abs(at.energy - 0.5 * e.squaredNorm())});
      // With some damping between that of the chord and that of the angle.
      const Eigen::Map<const Eigen::VectorXd> step(at.step.data(), n);
      const Eigen::VectorXd gradient = own.transpose() * (e - own * step);
      const double damping =
          step.squaredNorm() > 1e-12 ? gradient.dot(step) / step.squaredNorm() : 0.0;
      if (damping > 1e-3) rest = std::max(rest, (gradient - damping * step).cwiseAbs().maxCoeff());
      CHECK(damping <= 0.1 * at.energy * 1.01 + 1e-6);
      CHECK(at.largest == step.cwiseAbs().maxCoeff());
      for (int i = 0; i < n; ++i) same = same && same_bits(at.step[i], any.step[i]);
    }
    CHECK(error < 1e-10);
    CHECK(slope < 1e-13);
    CHECK(size < 1e-11);
    CHECK(rest < 1e-9);
    CHECK(same);
  }
}
