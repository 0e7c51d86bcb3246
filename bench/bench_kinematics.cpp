// Forward kinematics, Jacobian and inverse kinematics against Orocos KDL: the same arms, the same
// random configurations, the same compiler and flags.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"
#include "bench.hpp"
#include "kdl_peer.hpp"

namespace armlet::bench {
namespace {

constexpr int kConfigurations = 1000;
constexpr double kTolerance = 1e-5;  // m and rad, of inverse kinematics
constexpr int kStarts = 100;

std::vector<Eigen::VectorXd> random_configurations(const Robot& robot) {
  Random random(1);
  std::vector<Eigen::VectorXd> list;
  for (int k = 0; k < kConfigurations; ++k) {
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    list.push_back(q);
  }
  return list;
}

void check_agreement(const Robot& robot, const std::vector<Eigen::VectorXd>& q, KdlArm& peer) {
  double worst = 0.0;
  for (int k = 0; k < kConfigurations; ++k) {
    Jacobian J;
    const PlainPose ours = to_plain(forward_and_jacobian(robot, q[static_cast<std::size_t>(k)], J));
    peer.pose(k);
    peer.jacobian(k);
    const PlainPose theirs = peer.last_pose();
    for (std::size_t i = 0; i < ours.size(); ++i) {
      worst = std::max(worst, std::abs(ours[i] - theirs[i]));
    }
    const std::vector<double> columns = peer.last_jacobian();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      worst = std::max(worst, std::abs(columns[i] - J.data()[i]));
    }
  }
  std::printf("%-10s %-24s %10.1e\n", robot.name().c_str(), "largest difference", worst);
}

// Each kernel is timed with inputs that are ready, then with inputs that wait for the last result.
void bench_forward(const Robot& robot, std::vector<Eigen::VectorXd> q, KdlArm& peer) {
  double last = 0.0;
  const auto ours = [&](int k) { return forward(robot, q[static_cast<std::size_t>(k)])(0, 3); };
  const auto theirs = [&](int k) { return peer.pose(k); };
  print_row("", "tool pose", compare(kConfigurations, ours, theirs));
  const auto ours_in_turn = [&](int k) {
    q[static_cast<std::size_t>(k)][0] += 0.0 * last;
    return last = ours(k);
  };
  const auto theirs_in_turn = [&](int k) {
    peer.change_first_joint(k, 0.0 * last);
    return last = theirs(k);
  };
  print_row("", "tool pose, in turn", compare(kConfigurations, ours_in_turn, theirs_in_turn));
  std::vector<Eigen::Isometry3d> frames(static_cast<std::size_t>(robot.n()));
  const auto all_frames = [&](int k) {
    return link_frames(robot, q[static_cast<std::size_t>(k)], frames)(0, 3);
  };
  print_row("", "all frames", compare(kConfigurations, all_frames, theirs));
}

void bench_jacobian(const Robot& robot, const std::vector<Eigen::VectorXd>& q, KdlArm& peer) {
  const auto ours = [&](int k) { return jacobian(robot, q[static_cast<std::size_t>(k)])(0, 0); };
  const auto theirs = [&](int k) { return peer.jacobian(k); };
  print_row("", "Jacobian", compare(kConfigurations, ours, theirs));
}

void bench_inverse(const Robot& robot, const std::vector<Eigen::VectorXd>& q, KdlArm& peer) {
  const Eigen::VectorXd middle = 0.5 * (robot.lower() + robot.upper());
  const std::vector<double> start(middle.begin(), middle.end());
  const IkOptions options{.seed = middle,
                          .choice = IkChoice::kFirst,
                          .position_tolerance = kTolerance,
                          .rotation_tolerance = kTolerance,
                          .starts = kStarts,
                          .diagnose = false};
  std::vector<Eigen::Isometry3d> goals;
  for (const Eigen::VectorXd& configuration : q) {
    goals.push_back(forward(robot, configuration));
    peer.add_goal(to_plain(goals.back()));
  }
  int found_ours = 0, found_theirs = 0, calls = 0;
  const auto ours = [&](int k) {
    const IkResult result = solve_ik(robot, goals[static_cast<std::size_t>(k)], options);
    found_ours += result.ok();
    ++calls;
    return result.q[0];
  };
  const auto theirs = [&](int k) {
    const bool found = peer.solve(k, start, kTolerance, kStarts);
    found_theirs += found;
    return found ? 1.0 : 0.0;
  };
  const Times times = compare(kConfigurations, ours, theirs, 3);
  print_row("", "inverse, from mid-range", times);
  std::printf("%-10s   found %.2f %%, KDL %.2f %%\n", "", 100.0 * found_ours / calls,
              100.0 * found_theirs / calls);
}

void bench_arm(const Robot& robot) {
  KdlArm peer = make_peer(robot);
  const std::vector<Eigen::VectorXd> q = random_configurations(robot);
  for (const Eigen::VectorXd& configuration : q) peer.add_configuration(configuration.data());
  check_agreement(robot, q, peer);
  bench_forward(robot, q, peer);
  bench_jacobian(robot, q, peer);
  bench_inverse(robot, q, peer);
}

}  // namespace
}  // namespace armlet::bench

int main() {
  std::printf("%-10s %-24s %10s %10s %9s\n", "ns/call", "", "armlet", "KDL", "");
  for (const char* name : {"puma560", "ur5", "scara", "panda"}) {
    armlet::bench::bench_arm(*armlet::make_robot(name));
  }
}
