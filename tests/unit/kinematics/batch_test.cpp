#include "armlet/kinematics/batch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
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
// right angle, huge ones, and those next to the bound from which on they count as huge.
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
      case 3:
        value = random.uniform(395.0, 410.0);
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

// Poses and Jacobians of a batch.
struct Results {
  std::size_t count;
  std::vector<double> poses, jacobians;

  Results(const Robot& robot, const std::vector<double>& q, InstructionSet set)
      : count(q.size() / static_cast<std::size_t>(robot.n())),
        poses(12 * count, -1.0),
        jacobians(6 * q.size(), -1.0) {
    forward_batch(robot, q, poses, set);
    jacobian_batch(robot, q, jacobians, set);
  }

  bool has_same_bits(std::size_t k, const Results& alone) const {
    bool same = true;
    for (std::size_t e = 0; e < alone.poses.size(); ++e) {
      same = same && same_bits(poses[e * count + k], alone.poses[e]);
    }
    for (std::size_t e = 0; e < alone.jacobians.size(); ++e) {
      same = same && same_bits(jacobians[e * count + k], alone.jacobians[e]);
    }
    return same;
  }
};

// Whether each configuration has the bits that it has when it is computed alone.
bool matches_each_alone(const Robot& robot, const std::vector<double>& q, InstructionSet set) {
  const Results all(robot, q, set);
  bool same = true;
  for (std::size_t k = 0; k < all.count; ++k) {
    const Eigen::VectorXd values = configuration(q, static_cast<std::size_t>(robot.n()), k);
    const Results alone(robot, {values.begin(), values.end()}, InstructionSet::kBaseline);
    same = same && all.has_same_bits(k, alone);
  }
  return same;
}

// From the world's origin along all frames to the tool.
double length_of_path(const Robot& robot, const Eigen::VectorXd& q) {
  std::vector<Eigen::Isometry3d> frames(static_cast<std::size_t>(robot.n()));
  const Eigen::Isometry3d tool = link_frames(robot, q, frames);
  frames.push_back(tool);
  double length = robot.T_world_base().translation().norm();
  Eigen::Vector3d from = robot.T_world_base().translation();
  for (const Eigen::Isometry3d& frame : frames) {
    length += (frame.translation() - from).norm();
    from = frame.translation();
  }
  return length;
}

// The largest difference from forward() and jacobian(), lengths in units of the distance to the
// tool.
double difference_from_single_calls(const Robot& robot, const std::vector<double>& q) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const Results all(robot, q, best_instruction_set());
  double worst = 0.0;
  for (std::size_t k = 0; k < all.count; ++k) {
    const Eigen::VectorXd values = configuration(q, n, k);
    const double length = length_of_path(robot, values);
    const auto compare = [&](double batch, double single, bool is_length) {
      const double difference = std::abs(batch - single);
      if (difference > 0.0) worst = std::max(worst, is_length ? difference / length : difference);
    };
    const Eigen::Isometry3d T = forward(robot, values);
    for (std::size_t e = 0; e < 12; ++e) {
      compare(all.poses[e * all.count + k], T.data()[4 * (e / 3) + e % 3], e >= 9);
    }
    const Jacobian J = jacobian(robot, values);
    for (std::size_t e = 0; e < 6 * n; ++e) {
      const bool turns = robot.joint(static_cast<int>(e / 6)).kind == JointKind::kRevolute;
      compare(all.jacobians[e * all.count + k], J.data()[e], turns && e % 6 < 3);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a configuration has the same bits alone, in any batch and on every instruction set") {
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
        same = same && matches_each_alone(robot, q, set);
      }
      CHECK(same);
    }
  }
}

TEST_CASE("any number of configurations will do, also none and fewer than lanes") {
  Random random(2);
  const Robot robot = *make_robot("panda");
  for (const InstructionSet set : kAllSets) {
    if (!is_supported(set)) continue;
    for (std::size_t count = 0; count <= 70; ++count) {
      CAPTURE(count);
      CHECK(matches_each_alone(robot, configurations(random, 7 * count), set));
    }
  }
}

// Quick sines and cosines are off by 2^-52 at most, and each joint brings some roundings of half of
// that, of which few add up.
TEST_CASE(
    "a batch is within 2e-16 (n + 2) of single calls, lengths in units of the distance to the "
    "tool") {
  Random random(3);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    double worst = 0.0;
    for (int arm = 0; arm < 100; ++arm) {
      const Robot robot = random_arm(random, n);
      const auto q = configurations(random, 200 * static_cast<std::size_t>(n));
      worst = std::max(worst, difference_from_single_calls(robot, q));
    }
    CHECK(worst < 2e-16 * (n + 2));
  }
}

TEST_CASE("wrong sizes are refused with both numbers") {
  const Robot robot = *make_robot("puma560");
  const std::vector<double> q(12);
  std::vector<double> out(24);
  CHECK_THROWS_WITH_AS(jacobian_batch(robot, q, out), "`jacobians` has 24 elements; expected 72.",
                       ArgumentError);
  CHECK_THROWS_WITH_AS(forward_batch(robot, std::vector<double>(13), out),
                       "`q` has 13 elements; expected a multiple of the 6 joints.", ArgumentError);
}

TEST_CASE("a value that is not finite is refused by joint and configuration") {
  const Robot robot = *make_robot("puma560");
  for (const std::size_t count : {1u, 3u, 7u, 20u}) {
    for (const InstructionSet set : kAllSets) {
      if (!is_supported(set)) continue;
      std::vector<double> q(6 * count, 0.25);
      const std::size_t k = count > 1 ? 2 : 0;
      q[4 * count + k] = std::numeric_limits<double>::infinity();
      std::vector<double> out(36 * count);
      const std::string message = "The value of joint 5 in configuration " + std::to_string(k + 1) +
                                  " is inf; expected a finite number.";
      const char* expected = message.c_str();
      CHECK_THROWS_WITH_AS(forward_batch(robot, q, std::span(out).first(12 * count), set), expected,
                           ArgumentError);
      CHECK_THROWS_WITH_AS(jacobian_batch(robot, q, out, set), expected, ArgumentError);
    }
  }
}
