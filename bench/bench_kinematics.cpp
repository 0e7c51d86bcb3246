// Forward kinematics, Jacobian and inverse kinematics against Orocos KDL: the same arms, the same
// random configurations, the same compiler and flags.
#include <cmath>
#include <cstdio>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"
#include "bench.hpp"

namespace armlet::bench {
namespace {

constexpr int kConfigurations = 1000;
constexpr double kTolerance = 1e-5;  // m and rad, of inverse kinematics
constexpr int kRestarts = 100;

KDL::Frame to_kdl(const Eigen::Isometry3d& T) {
  const auto& R = T.linear();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                        R(2, 2)),
          KDL::Vector(T(0, 3), T(1, 3), T(2, 3))};
}

// The same arm in KDL, with as few segments as it allows.
KDL::Chain to_kdl(const Robot& robot) {
  const Chain& chain = robot.chain();
  const auto X = [&](int i) {
    return KDL::Frame(KDL::Rotation::RotX(std::atan2(chain.sin_alpha[i], chain.cos_alpha[i])),
                      KDL::Vector(chain.a[i], 0, 0));
  };
  KDL::Chain result;
  const KDL::Frame base = to_kdl(robot.T_world_base()) * X(0);
  if (!KDL::Equal(base, KDL::Frame::Identity(), 1e-15))
    result.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), base));
  for (int i = 0; i < chain.n; ++i) {
    const double theta =
        chain.revolute[i] ? chain.theta[i] : std::atan2(chain.sin_theta[i], chain.cos_theta[i]);
    KDL::Frame tip =
        KDL::Frame(KDL::Rotation::RotZ(theta), KDL::Vector(0, 0, chain.d[i])) * X(i + 1);
    if (i == chain.n - 1) tip = tip * to_kdl(robot.T_flange_tool());
    const auto type = chain.revolute[i] ? KDL::Joint::RotZ : KDL::Joint::TransZ;
    result.addSegment(KDL::Segment(KDL::Joint(type), tip));
  }
  return result;
}

struct Inputs {
  std::vector<Eigen::VectorXd> ours;
  std::vector<KDL::JntArray> theirs;
};

Inputs random_configurations(const Robot& robot) {
  Random random(1);
  Inputs inputs;
  for (int k = 0; k < kConfigurations; ++k) {
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    KDL::JntArray array(static_cast<unsigned>(robot.n()));
    array.data = q;
    inputs.ours.push_back(q);
    inputs.theirs.push_back(array);
  }
  return inputs;
}

double largest_difference(const Eigen::Isometry3d& a, const KDL::Frame& b) {
  double largest = 0.0;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a(r, c) - b.M(r, c)));
    largest = std::max(largest, std::abs(a(r, 3) - b.p(r)));
  }
  return largest;
}

// Each kernel is timed with inputs that are ready, then with inputs that wait for the last result.
void bench_forward(const Robot& robot, Inputs inputs, KDL::ChainFkSolverPos_recursive& fk) {
  KDL::Frame frame;
  double difference = 0.0, last = 0.0;
  for (int k = 0; k < kConfigurations; ++k) {
    fk.JntToCart(inputs.theirs[k], frame);
    difference = std::max(difference, largest_difference(forward(robot, inputs.ours[k]), frame));
  }
  const auto ours = [&](int k) { return forward(robot, inputs.ours[k])(0, 3); };
  const auto theirs = [&](int k) { return fk.JntToCart(inputs.theirs[k], frame), frame.p(0); };
  print_row(robot.name().c_str(), "tool pose", compare(kConfigurations, ours, theirs));
  const auto ours_in_turn = [&](int k) {
    inputs.ours[k][0] += 0.0 * last;
    return last = ours(k);
  };
  const auto theirs_in_turn = [&](int k) {
    inputs.theirs[k](0) += 0.0 * last;
    return last = theirs(k);
  };
  print_row("", "tool pose, in turn", compare(kConfigurations, ours_in_turn, theirs_in_turn));
  if (difference > 1e-12) std::printf("%-10s poses differ by %.1e\n", "", difference);
}

void bench_jacobian(const Robot& robot, const Inputs& inputs, const KDL::Chain& chain) {
  KDL::ChainJntToJacSolver solver(chain);
  KDL::Jacobian J(static_cast<unsigned>(robot.n()));
  double difference = 0.0;
  for (int k = 0; k < kConfigurations; ++k) {
    solver.JntToJac(inputs.theirs[k], J);
    difference =
        std::max(difference, (jacobian(robot, inputs.ours[k]) - J.data).cwiseAbs().maxCoeff());
  }
  const auto ours = [&](int k) { return jacobian(robot, inputs.ours[k])(0, 0); };
  const auto theirs = [&](int k) { return solver.JntToJac(inputs.theirs[k], J), J(0, 0); };
  print_row("", "Jacobian", compare(kConfigurations, ours, theirs));
  if (difference > 1e-12) std::printf("%-10s Jacobians differ by %.1e\n", "", difference);
}

// KDL's solver with weights for metres and radians, restarted at random until its answer is within
// the limits: the settings that serve it best.
class KdlSolver {
 public:
  KdlSolver(const Robot& robot, const KDL::Chain& chain)
      : robot_(robot), lma_(chain, Eigen::Matrix<double, 6, 1>::Ones(), kTolerance) {}

  bool solve(const KDL::Frame& goal, const Eigen::VectorXd& start, KDL::JntArray& q) {
    KDL::JntArray from(static_cast<unsigned>(robot_.n()));
    from.data = start;
    for (int restart = 0; restart < kRestarts; ++restart) {
      if (lma_.CartToJnt(from, goal, q) == 0 && wrap_into_limits(q)) return true;
      for (int i = 0; i < robot_.n(); ++i)
        from.data[i] = random_.uniform(robot_.lower()[i], robot_.upper()[i]);
    }
    return false;
  }

 private:
  bool wrap_into_limits(KDL::JntArray& q) const {
    for (int i = 0; i < robot_.n(); ++i) {
      const double turn = robot_.is_revolute(i) ? 2.0 * M_PI : 0.0;
      double& value = q.data[i];
      if (turn > 0.0) value -= turn * std::ceil((value - robot_.upper()[i]) / turn);
      if (value < robot_.lower()[i] || value > robot_.upper()[i]) return false;
    }
    return true;
  }

  const Robot& robot_;
  KDL::ChainIkSolverPos_LMA lma_;
  Random random_{2};
};

void bench_inverse(const Robot& robot, const Inputs& inputs, const KDL::Chain& chain) {
  const Eigen::VectorXd middle = 0.5 * (robot.lower() + robot.upper());
  const IkOptions options{.seed = middle,
                          .choice = IkChoice::kFirst,
                          .position_tolerance = kTolerance,
                          .rotation_tolerance = kTolerance,
                          .starts = kRestarts,
                          .diagnose = false};
  std::vector<Eigen::Isometry3d> goals;
  for (const auto& q : inputs.ours) goals.push_back(forward(robot, q));
  int found_ours = 0, found_theirs = 0, calls = 0;
  KdlSolver solver(robot, chain);
  KDL::JntArray q(static_cast<unsigned>(robot.n()));
  const auto ours = [&](int k) {
    const IkResult result = solve_ik(robot, goals[k], options);
    found_ours += result.ok();
    ++calls;
    return result.q[0];
  };
  const auto theirs = [&](int k) {
    found_theirs += solver.solve(to_kdl(goals[k]), middle, q);
    return q(0);
  };
  const Times times = compare(kConfigurations, ours, theirs, 3);
  print_row("", "inverse, from mid-range", times);
  std::printf("%-10s   found %.2f %%, KDL %.2f %%\n", "", 100.0 * found_ours / calls,
              100.0 * found_theirs / calls);
}

void bench_arm(const Robot& robot) {
  const KDL::Chain chain = to_kdl(robot);
  KDL::ChainFkSolverPos_recursive fk(chain);
  const Inputs inputs = random_configurations(robot);
  bench_forward(robot, inputs, fk);
  bench_jacobian(robot, inputs, chain);
  bench_inverse(robot, inputs, chain);
}

}  // namespace
}  // namespace armlet::bench

int main() {
  std::printf("%-10s %-24s %10s %10s %9s\n", "ns/call", "", "armlet", "KDL", "");
  for (const char* name : {"puma560", "scara", "panda"})
    armlet::bench::bench_arm(*armlet::make_robot(name));
}
