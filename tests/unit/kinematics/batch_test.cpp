#include "armlet/kinematics/batch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

constexpr InstructionSet kAllSets[] = {InstructionSet::kBaseline, InstructionSet::kAvx2,
                                       InstructionSet::kAvx512};

// Random values with the angles that kernels treat apart among them: zero, exact multiples of a
// right angle, huge ones.
std::vector<double> configurations(Random& random, std::size_t size) {
  std::vector<double> q(size);
  for (double& value : q) {
    switch (random.below(40)) {
      case 0:
        value = 0.0;
        break;
      case 1:
        value = 1.5707963267948966 * static_cast<double>(random.below(9));
        break;
      case 2:
        value = random.uniform(-1e9, 1e9);
        break;
      default:
        value = random.uniform(-7.0, 7.0);
    }
  }
  return q;
}

Eigen::VectorXd configuration(const std::vector<double>& q, std::size_t n, std::size_t k) {
  const std::size_t count = q.size() / n;
  Eigen::VectorXd column(static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) column[static_cast<Eigen::Index>(i)] = q[i * count + k];
  return column;
}

// Whether every number that the batch gives has the bits of single calls.
bool matches_single_calls(const Robot& robot, const std::vector<double>& q, InstructionSet set) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const std::size_t count = q.size() / n;
  std::vector<double> poses(12 * count, -1.0);
  std::vector<double> jacobians(6 * n * count, -1.0);
  forward_batch(robot, q, poses, set);
  jacobian_batch(robot, q, jacobians, set);
  bool same = true;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::VectorXd values = configuration(q, n, k);
    const Eigen::Isometry3d T = forward(robot, values);
    for (std::size_t e = 0; e < 12; ++e) {
      same = same && same_bits(poses[e * count + k], T.data()[4 * (e / 3) + e % 3]);
    }
    const Jacobian J = jacobian(robot, values);
    for (std::size_t e = 0; e < 6 * n; ++e) {
      same = same && same_bits(jacobians[e * count + k], J.data()[e]);
    }
  }
  return same;
}

}  // namespace

TEST_CASE("a batch has the bits of single calls on every instruction set of this machine") {
  for (const InstructionSet set : kAllSets) {
    if (!is_supported(set)) continue;
    Random random(1);
    for (int n = 1; n <= kMaxJoints; ++n) {
      CAPTURE(n);
      bool same = true;
      for (int arm = 0; arm < 30; ++arm) {
        const Robot robot = random_arm(random, n);
        const std::size_t count = random.below(40);
        const auto q = configurations(random, count * static_cast<std::size_t>(n));
        same = same && matches_single_calls(robot, q, set);
      }
      CHECK(same);
    }
  }
}

TEST_CASE("any number of configurations will do, also none and fewer than lanes") {
  Random random(2);
  const Robot robot = make_panda();
  for (const InstructionSet set : kAllSets) {
    if (!is_supported(set)) continue;
    for (std::size_t count = 0; count <= 33; ++count) {
      CAPTURE(count);
      CHECK(matches_single_calls(robot, configurations(random, 7 * count), set));
    }
  }
}

TEST_CASE("the best instruction set is the largest that is supported") {
  CHECK(is_supported(InstructionSet::kBaseline));
  const InstructionSet best = best_instruction_set();
  for (const InstructionSet set : kAllSets) CHECK(is_supported(set) == (set <= best));
}

TEST_CASE("wrong sizes are refused with both numbers") {
  const Robot robot = make_puma560();
  const std::vector<double> q(12);
  std::vector<double> out(24);
  CHECK_THROWS_WITH_AS(jacobian_batch(robot, q, out), "`jacobians` has 24 elements; expected 72.",
                       ArgumentError);
  CHECK_THROWS_WITH_AS(forward_batch(robot, std::vector<double>(13), out),
                       "`q` has 13 elements; expected a multiple of the 6 joints.", ArgumentError);
}

TEST_CASE("a value that is not finite is refused by joint and configuration") {
  const Robot robot = make_puma560();
  for (const std::size_t count : {3u, 20u}) {
    for (const InstructionSet set : kAllSets) {
      if (!is_supported(set)) continue;
      std::vector<double> q(6 * count, 0.25);
      q[4 * count + 2] = std::numeric_limits<double>::infinity();
      std::vector<double> out(36 * count);
      const char* expected =
          "The value of joint 5 in configuration 3 is inf; expected a finite number.";
      CHECK_THROWS_WITH_AS(forward_batch(robot, q, std::span(out).first(12 * count), set), expected,
                           ArgumentError);
      CHECK_THROWS_WITH_AS(jacobian_batch(robot, q, out, set), expected, ArgumentError);
    }
  }
}
