#include <doctest/doctest.h>

#include "armlet/dynamics/batch.hpp"
#include "armlet/dynamics/coriolis.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/model/catalog.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// An arm in motion.
struct Case {
  Robot robot;
  VectorXd q, qd, qdd;
  int n() const { return robot.n(); }
};

Case random_case(Random& random, int n) {
  Robot robot = random_heavy_arm(random, n);
  VectorXd q = random_values(random, n);
  return {std::move(robot), q, random_rates(random, n), random_rates(random, n)};
}

double distance(const MatrixXd& a, const MatrixXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

double size_of(const MatrixXd& a) { return std::max(1.0, a.cwiseAbs().maxCoeff()); }

// 1 where the difference is the tolerance: `tolerance` times the largest number involved.
double over(double difference, double scale, double tolerance) {
  return difference / (scale * tolerance);
}

template <class Check>
void for_random_arms(int per_size, const Check& check) {
  Random random(17);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    for (int arm = 0; arm < per_size; ++arm) check(random_case(random, n));
  }
}

constexpr int kArmsPerSize = 834;  // 10,008 arms in all

}  // namespace

TEST_CASE(
    "forces are inertia times acceleration, Coriolis forces and gravity: 10,000 random arms") {
  double sum = 0.0, columns = 0.0, gravity = 0.0, bias = 0.0;
  for_random_arms(kArmsPerSize, [&](const Case& c) {
    const MatrixXd M = mass_matrix(c.robot, c.q);
    const VectorXd h = bias_forces(c.robot, c.q, c.qd),
                   tau = inverse_dynamics(c.robot, c.q, c.qd, c.qdd);
    const double scale = size_of(M) + size_of(h) + size_of(tau);
    sum = std::max(sum, over(distance(tau, M * c.qdd + h), scale, 1e-12));
    const VectorXd zero = VectorXd::Zero(c.n());
    const VectorXd g = gravity_forces(c.robot, c.q);
    gravity = std::max(gravity,
                       over(distance(g, inverse_dynamics(c.robot, c.q, zero, zero)), scale, 1e-12));
    bias = std::max(bias, over(distance(h, coriolis_forces(c.robot, c.q, c.qd) + g), scale, 1e-12));
    for (int i = 0; i < c.n(); ++i) {
      const VectorXd column = inverse_dynamics(c.robot, c.q, zero, VectorXd::Unit(c.n(), i)) - g;
      columns = std::max(columns, over(distance(column, M.col(i)), scale, 1e-12));
    }
  });
  CHECK(sum < 1.0);
  CHECK(columns < 1.0);
  CHECK(gravity < 1.0);
  CHECK(bias < 1.0);
}

// The acceleration is only as certain as the matrix is well conditioned; the forces that it causes
// are compared, which are.
TEST_CASE("forward dynamics undoes inverse dynamics, and articulated bodies agree: 10,000 arms") {
  double undone = 0.0, articulated = 0.0;
  for_random_arms(kArmsPerSize, [&](const Case& c) {
    const VectorXd tau = inverse_dynamics(c.robot, c.q, c.qd, c.qdd);
    const MatrixXd M = mass_matrix(c.robot, c.q);
    const double scale = size_of(M) + size_of(tau) + size_of(bias_forces(c.robot, c.q, c.qd));
    const VectorXd ours = forward_dynamics(c.robot, c.q, c.qd, tau);
    undone = std::max(undone, over(distance(M * ours, M * c.qdd), scale, 1e-12));
    const VectorXd theirs = articulated_body(c.robot, c.q, c.qd, tau);
    articulated = std::max(articulated, over(distance(M * ours, M * theirs), scale, 1e-12));
  });
  CHECK(undone < 1.0);
  CHECK(articulated < 10.0);
}

TEST_CASE("the inertia matrix is symmetric and positive definite, and gives the kinetic energy") {
  for_random_arms(100, [](const Case& c) {
    const MatrixXd M = mass_matrix(c.robot, c.q);
    CHECK(M == M.transpose());
    CHECK(M.llt().info() == Eigen::Success);
    CHECK(kinetic_energy(c.robot, c.q, c.qd) ==
          doctest::Approx(0.5 * c.qd.dot(M * c.qd)).epsilon(1e-13));
  });
}

// Central differences are off by the square of their step and by rounding over it.
TEST_CASE("gravity is the slope of the potential energy") {
  for_random_arms(30, [](const Case& c) {
    const VectorXd g = gravity_forces(c.robot, c.q);
    for (int i = 0; i < c.n(); ++i) {
      const VectorXd step = 1e-5 * VectorXd::Unit(c.n(), i);
      const double slope =
          (potential_energy(c.robot, c.q + step) - potential_energy(c.robot, c.q - step)) / 2e-5;
      CHECK(std::abs(slope - g[i]) < 1e-7 * size_of(g));
    }
  });
}

TEST_CASE("gravity along parallel axes is carried by what slides, and no joint value may be NaN") {
  Random random(23);
  for (const std::string_view name : {"scara", "planar3"}) {
    const Robot robot = *make_robot(name);
    for (int trial = 0; trial < 50; ++trial) {
      VectorXd q = random_values(random, robot.n());
      const VectorXd g = gravity_forces(robot, q), zero = VectorXd::Zero(robot.n());
      CHECK(distance(g, inverse_dynamics(robot, q, zero, zero)) < 1e-12 * size_of(g));
      for (const double wrong : {NAN, INFINITY}) {
        q[trial % robot.n()] = wrong;
        CHECK_THROWS_AS((void)gravity_forces(robot, q), ArgumentError);
      }
    }
  }
}

TEST_CASE("the Coriolis matrix gives the forces, and dM/dt - 2 C is skew-symmetric: 10,000 arms") {
  double forces = 0.0, skew = 0.0;
  for_random_arms(kArmsPerSize, [&](const Case& c) {
    const MatrixXd C = coriolis_matrix(c.robot, c.q, c.qd);
    const double scale = size_of(C) * c.n();
    forces = std::max(forces,
                      over(distance(C * c.qd, coriolis_forces(c.robot, c.q, c.qd)), scale, 1e-12));
    const double h = 1e-5;
    const MatrixXd rate =
        (mass_matrix(c.robot, c.q + h * c.qd) - mass_matrix(c.robot, c.q - h * c.qd)) / (2.0 * h);
    const MatrixXd N = rate - 2.0 * C;
    skew = std::max(
        skew, over(distance(N, -N.transpose()), size_of(mass_matrix(c.robot, c.q)) + scale, 1e-7));
  });
  CHECK(forces < 1.0);
  CHECK(skew < 1.0);
}

// The symbols of Christoffel from differences of the inertia matrix.
TEST_CASE("the Coriolis matrix is that of the Christoffel symbols") {
  for_random_arms(8, [](const Case& c) {
    const int n = c.n();
    std::vector<MatrixXd> slope;
    for (int k = 0; k < n; ++k) {
      const VectorXd step = 1e-5 * VectorXd::Unit(n, k);
      slope.push_back((mass_matrix(c.robot, c.q + step) - mass_matrix(c.robot, c.q - step)) / 2e-5);
    }
    MatrixXd C = MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        for (int k = 0; k < n; ++k) {
          const auto at = [&](int m, int row, int column) {
            return slope[static_cast<std::size_t>(m)](row, column);
          };
          C(i, j) += 0.5 * (at(k, i, j) + at(j, i, k) - at(i, j, k)) * c.qd[k];
        }
      }
    }
    CHECK(distance(coriolis_matrix(c.robot, c.q, c.qd), C) <
          1e-7 * (size_of(C) + size_of(mass_matrix(c.robot, c.q))));
  });
}

TEST_CASE("the derivatives of inverse dynamics are the limits of its differences") {
  for_random_arms(20, [](const Case& c) {
    const ForceDerivatives D = inverse_dynamics_derivatives(c.robot, c.q, c.qd, c.qdd);
    const double scale =
        size_of(inverse_dynamics(c.robot, c.q, c.qd, c.qdd)) + size_of(D.by_q) + size_of(D.by_qd);
    for (int i = 0; i < c.n(); ++i) {
      const VectorXd step = 1e-5 * VectorXd::Unit(c.n(), i);
      const VectorXd by_q = (inverse_dynamics(c.robot, c.q + step, c.qd, c.qdd) -
                             inverse_dynamics(c.robot, c.q - step, c.qd, c.qdd)) /
                            2e-5;
      const VectorXd by_qd = (inverse_dynamics(c.robot, c.q, c.qd + step, c.qdd) -
                              inverse_dynamics(c.robot, c.q, c.qd - step, c.qdd)) /
                             2e-5;
      CHECK(distance(D.by_q.col(i), by_q) < 1e-7 * scale);
      CHECK(distance(D.by_qd.col(i), by_qd) < 1e-7 * scale);
    }
  });
}

TEST_CASE("a motion of a batch has the bits of a single one, on every instruction set") {
  Random random(5);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    Robot robot = random_heavy_arm(random, n);
    RobotSpec spec = robot.spec();
    for (Link& link : spec.links) link.friction = {1e-4, 0.02, -0.03};
    robot = Robot(spec);
    for (const int count : {1, 2, 3, 5, 8, 9, 16, 31, 40, 77}) {
      const std::size_t size = static_cast<std::size_t>(n * count);
      std::vector<double> q(size), qd(size), qdd(size), tau(size);
      for (std::size_t k = 0; k < size; ++k) {
        q[k] = random.uniform(-4.0, 4.0);
        qd[k] = random.uniform(-2.0, 2.0);
        qdd[k] = random.uniform(-2.0, 2.0);
      }
      for (const InstructionSet set :
           {InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
        if (!is_supported(set)) continue;
        inverse_dynamics_batch(robot, q, qd, qdd, tau, set);
        int different = 0;
        for (int k = 0; k < count; ++k) {
          VectorXd one[3] = {VectorXd(n), VectorXd(n), VectorXd(n)};
          for (int i = 0; i < n; ++i) {
            const std::size_t at = static_cast<std::size_t>(i * count + k);
            one[0][i] = q[at];
            one[1][i] = qd[at];
            one[2][i] = qdd[at];
          }
          const VectorXd single = inverse_dynamics(robot, one[0], one[1], one[2]);
          for (int i = 0; i < n; ++i)
            different += !same_bits(single[i], tau[static_cast<std::size_t>(i * count + k)]);
        }
        CHECK(different == 0);
      }
    }
  }
}
