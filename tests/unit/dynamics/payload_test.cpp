#include <doctest/doctest.h>

#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::Matrix3d;
using Eigen::VectorXd;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Payload random_payload(Random& random) {
  const Link body = random_link(random);
  return {.mass = body.mass, .com = body.com, .inertia = body.inertia};
}

Matrix3d cross(const Eigen::Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

// The 6 x 6 inertia of a body about the origin of its frame, in which bodies simply add up.
Matrix6 spatial(double mass, const Eigen::Vector3d& com, const Matrix3d& inertia) {
  Matrix6 I;
  I << inertia + mass * cross(com) * cross(com).transpose(), mass * cross(com),
      mass * cross(com).transpose(), mass * Matrix3d::Identity();
  return I;
}

}  // namespace

TEST_CASE("two rigid bodies together have the sum of their spatial inertias") {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Payload a = random_payload(random), b = random_payload(random), ab = together(a, b);
    const Matrix6 sum = spatial(a.mass, a.com, a.inertia) + spatial(b.mass, b.com, b.inertia);
    CHECK((spatial(ab.mass, ab.com, ab.inertia) - sum).cwiseAbs().maxCoeff() < 1e-13);
  }
  const Payload nothing = together({}, {});
  CHECK(nothing.mass == 0.0);
  CHECK(nothing.com.isZero());
}

TEST_CASE(
    "a payload costs what the same body in the last link costs, and the transfer of its weight") {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const int n = 1 + k % kMaxJoints;
    const Robot robot = random_heavy_arm(random, n);
    const Payload payload = random_payload(random);
    Link last = robot.link(n - 1);
    const double mass = last.mass + payload.mass;
    const Eigen::Vector3d com = (last.mass * last.com + payload.mass * payload.com) / mass;
    const auto about = [&](double m, const Eigen::Vector3d& c,
                           const Matrix3d& inertia) -> Matrix3d {
      return inertia + m * cross(c - com) * cross(c - com).transpose();
    };
    last.inertia = about(last.mass, last.com, last.inertia) +
                   about(payload.mass, payload.com, payload.inertia);
    last.com = com;
    last.mass = mass;
    const Robot by_hand = robot.with_link(n - 1, last), loaded = robot.with_payload(payload);
    const VectorXd q = random_values(random, n), qd = random_rates(random, n),
                   qdd = random_rates(random, n);
    const VectorXd tau = inverse_dynamics(by_hand, q, qd, qdd);
    const double scale = 1e-12 * (1.0 + tau.cwiseAbs().maxCoeff());
    CHECK((inverse_dynamics(loaded, q, qd, qdd) - tau).cwiseAbs().maxCoeff() < scale);
    CHECK(potential_energy(loaded, q) == doctest::Approx(potential_energy(by_hand, q)));
    const double more = kinetic_energy(loaded, q, qd) - kinetic_energy(robot, q, qd);
    CHECK(more > 0.0);  // a body in motion
  }
}
