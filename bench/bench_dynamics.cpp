// Inverse dynamics, gravity, inertia matrix and forward dynamics compared with Orocos KDL: the same
// arms, random motions, compiler and flags. Inputs change from call to call, results are used, and
// the figures are medians over rounds in which the two alternate. The arms have no motors and no
// friction, because KDL has none.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/dynamics/batch.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/dynamics/simulation.hpp"
#include "armlet/model/catalog.hpp"
#include "bench.hpp"
#include "instruction_sets.hpp"
#include "kdl_dynamics.hpp"
#include "kdl_peer.hpp"

namespace armlet::bench {
namespace {

constexpr int kMotions = 1000;
constexpr int kRounds = 41;

Robot without_motors(const Robot& robot) {
  RobotSpec spec = robot.spec();
  for (Link& link : spec.links) {
    link.motor_inertia = 0.0;
    link.friction = {};
  }
  return Robot(spec);
}

struct Motions {
  std::vector<Eigen::VectorXd> q, qd, qdd, tau;

  explicit Motions(const Robot& robot) {
    Random random(1);
    const auto draw = [&](const Eigen::VectorXd& low, const Eigen::VectorXd& high) {
      Eigen::VectorXd values(robot.n());
      for (int i = 0; i < robot.n(); ++i) values[i] = random.uniform(low[i], high[i]);
      return values;
    };
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(robot.n());
    for (int k = 0; k < kMotions; ++k) {
      q.push_back(draw(robot.lower(), robot.upper()));
      qd.push_back(draw(-2.0 * one, 2.0 * one));
      qdd.push_back(draw(-5.0 * one, 5.0 * one));
      tau.push_back(draw(-20.0 * one, 20.0 * one));
    }
  }
};

// The frame of a body in KDL is the one after X_{i+1} of the chain, which is the frame of the link
// in the standard convention.
std::vector<KdlBody> bodies_of(const Robot& robot) {
  const Chain& chain = robot.chain();
  std::vector<KdlBody> bodies;
  for (int i = 0; i < robot.n(); ++i) {
    const Link& link = robot.link(i);
    Eigen::Vector3d com = link.com;
    Eigen::Matrix3d I = link.inertia;
    if (!chain.standard) {
      const std::size_t x = static_cast<std::size_t>(i) + 1;
      Eigen::Matrix3d R;
      R << 1, 0, 0, 0, chain.cos_alpha[x], chain.sin_alpha[x], 0, -chain.sin_alpha[x],
          chain.cos_alpha[x];
      com = R * (com - Eigen::Vector3d(chain.a[x], 0, 0));
      I = R * I * R.transpose();
    }
    bodies.push_back({link.mass,
                      {com.x(), com.y(), com.z()},
                      {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}});
  }
  return bodies;
}

KdlDynamics peer_of(const Robot& robot) {
  const Chain& chain = robot.chain();
  std::vector<KdlJoint> joints;
  const auto alpha = [&](std::size_t i) {
    return std::atan2(chain.sin_alpha[i], chain.cos_alpha[i]);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.n); ++i) {
    joints.push_back({chain.revolute[i], chain.theta[i], chain.d[i], chain.a[i + 1], alpha(i + 1)});
  }
  const double* B = robot.walk_plan().base.data();
  const Eigen::Vector3d g = Eigen::Map<const Eigen::Matrix3d>(B).transpose() * robot.gravity();
  return KdlDynamics(joints, bodies_of(robot), {g.x(), g.y(), g.z()});
}

double difference(const double* ours, const std::vector<double>& theirs) {
  double worst = 0.0, scale = 1.0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    worst = std::max(worst, std::abs(ours[i] - theirs[i]));
    scale = std::max(scale, std::abs(theirs[i]));
  }
  return worst / scale;
}

void check_agreement(const Robot& robot, const Motions& m, KdlDynamics& peer) {
  double worst[4] = {};
  for (int k = 0; k < kMotions; ++k) {
    const std::size_t i = static_cast<std::size_t>(k);
    peer.inverse(k);
    worst[0] = std::max(
        worst[0],
        difference(inverse_dynamics(robot, m.q[i], m.qd[i], m.qdd[i]).data(), peer.last_forces()));
    peer.gravity(k);
    worst[1] =
        std::max(worst[1], difference(gravity_forces(robot, m.q[i]).data(), peer.last_forces()));
    peer.mass(k);
    worst[2] = std::max(worst[2], difference(mass_matrix(robot, m.q[i]).data(), peer.last_mass()));
    peer.forward(k);
    worst[3] = std::max(
        worst[3],
        difference(forward_dynamics(robot, m.q[i], m.qd[i], m.tau[i]).data(), peer.last_forces()));
  }
  std::printf("%-10s largest differences: inverse %.0e, gravity %.0e, mass %.0e, forward %.0e\n",
              robot.name().c_str(), worst[0], worst[1], worst[2], worst[3]);
}

void bench_batch(const Robot& robot, const Motions& m) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  std::vector<double> q(n * kMotions), qd(q), qdd(q), tau(q);
  for (std::size_t k = 0; k < kMotions; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      q[i * kMotions + k] = m.q[k][row];
      qd[i * kMotions + k] = m.qd[k][row];
      qdd[i * kMotions + k] = m.qdd[k][row];
    }
  }
  const auto single = [&](int k) {
    const std::size_t i = static_cast<std::size_t>(k);
    return inverse_dynamics(robot, m.q[i], m.qd[i], m.qdd[i])[0];
  };
  for (const auto& [set, name] : kSets) {
    if (!is_supported(set)) continue;
    const auto all = [&](int k) {
      inverse_dynamics_batch(robot, q, qd, qdd, tau, set);
      return tau[static_cast<std::size_t>(k)];
    };
    Times times = compare({1, kMotions}, all, single, kRounds);
    times.ours /= kMotions;
    print_row("", (std::string("inverse, ") + name).c_str(), times,
              set == InstructionSet::kAvx2     ? "own; at least 4"
              : set == InstructionSet::kAvx512 ? "own; at least 7"
                                               : "own");
  }
}

void bench_arm(const Robot& robot) {
  const Motions m(robot);
  KdlDynamics peer = peer_of(robot);
  for (int k = 0; k < kMotions; ++k) {
    const std::size_t i = static_cast<std::size_t>(k);
    peer.add_motion(m.q[i].data(), m.qd[i].data(), m.qdd[i].data(), m.tau[i].data());
  }
  check_agreement(robot, m, peer);
  const auto at = [](const std::vector<Eigen::VectorXd>& list, int k) -> const Eigen::VectorXd& {
    return list[static_cast<std::size_t>(k)];
  };
  const auto row = [](const char* what, const auto& ours, const auto& theirs, const char* target) {
    print_row("", what, compare(kMotions, ours, theirs, kRounds), target);
  };
  row(
      "inverse dynamics",
      [&](int k) { return inverse_dynamics(robot, at(m.q, k), at(m.qd, k), at(m.qdd, k))[0]; },
      [&](int k) { return peer.inverse(k); }, "at least 9");
  row(
      "gravity", [&](int k) { return gravity_forces(robot, at(m.q, k))[0]; },
      [&](int k) { return peer.gravity(k); }, "at least 18");
  row(
      "mass matrix", [&](int k) { return mass_matrix(robot, at(m.q, k))(0, 0); },
      [&](int k) { return peer.mass(k); }, "at least 11");
  row(
      "forward dynamics",
      [&](int k) { return forward_dynamics(robot, at(m.q, k), at(m.qd, k), at(m.tau, k))[0]; },
      [&](int k) { return peer.forward(k); }, "at least 8");
  bench_batch(robot, m);
}

// One second of simulation with torques constant for 1 ms, steps of 1 ms, motors and friction.
void bench_second(const std::shared_ptr<const Robot>& robot) {
  std::vector<double> times;
  for (int round = 0; round < kRounds; ++round) {
    ArmSimulation arm(robot, robot->home(), Eigen::VectorXd::Constant(robot->n(), 0.1));
    const auto hold = [&](int) {
      (void)arm.advance(gravity_forces(*robot, arm.q()), 1e-3);
      return arm.q()[0];
    };
    times.push_back(1e-3 * nanoseconds_per_call(1000, hold));
  }
  std::printf("%-10s %-24s %10.2f ms; at most 3 ms for a Puma 560\n", "", "one second, rk4",
              median(times));
}

}  // namespace
}  // namespace armlet::bench

// bench_dynamics [ROBOT...]
int main(int count, char** arguments) {
  for (const std::string& name : armlet::bench::begin_comparison(count, arguments)) {
    const auto robot = armlet::make_robot(name);
    if (!robot) continue;
    armlet::bench::bench_arm(armlet::bench::without_motors(*robot));
    armlet::bench::bench_second(robot);
  }
}
