// Forward kinematics, Jacobian and inverse kinematics compared with Orocos KDL: the same arms,
// random configurations, compiler and flags. Inputs change from call to call, results are used, and
// the figures are medians over rounds in which the two alternate.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/batch.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"
#include "bench.hpp"
#include "instruction_sets.hpp"
#include "kdl_peer.hpp"
#include "kinematics/closed_form/canonical_rows.hpp"
#include "kinematics/closed_form/closed_lanes.hpp"

namespace armlet::bench {
namespace {

constexpr int kConfigurations = 1000;
constexpr int kRounds = 31;
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

int count_solutions(const ClosedForm& closed, const Eigen::Isometry3d& goal,
                    const Eigen::VectorXd& q_near) {
  static ClosedSolutions solutions;
  return closed.solve(goal, q_near, solutions);
}

void check_agreement(const Robot& robot, const std::vector<Eigen::VectorXd>& q, KdlArm& peer) {
  double worst = 0.0;
  for (int k = 0; k < kConfigurations; ++k) {
    Jacobian J;
    forward_and_jacobian(robot, q[static_cast<std::size_t>(k)], J);
    const PlainPose ours = to_plain(forward(robot, q[static_cast<std::size_t>(k)]));
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

// Both sides; each input depends on the previous result.
template <class Ours, class Theirs>
void compare_alternately(const char* what, std::vector<Eigen::VectorXd>& q, KdlArm& peer,
                         const Ours& ours, const Theirs& theirs) {
  double last = 0.0;
  const auto ours_alternately = [&](int k) {
    q[static_cast<std::size_t>(k)][0] += 0.0 * last;
    return last = ours(k);
  };
  const auto theirs_alternately = [&](int k) {
    peer.change_first_joint(k, 0.0 * last);
    return last = theirs(k);
  };
  print_row("", what, compare(kConfigurations, ours_alternately, theirs_alternately, kRounds));
}

// First with independent inputs, then with inputs that depend on the previous result.
void bench_forward(const Robot& robot, std::vector<Eigen::VectorXd> q, KdlArm& peer) {
  const auto ours = [&](int k) { return forward(robot, q[static_cast<std::size_t>(k)])(0, 3); };
  const auto theirs = [&](int k) { return peer.pose(k); };
  print_row("", "tool pose", compare(kConfigurations, ours, theirs, kRounds), "at least 5");
  compare_alternately("tool pose, in turn", q, peer, ours, theirs);
  std::vector<Eigen::Isometry3d> frames(static_cast<std::size_t>(robot.n()));
  const auto all_frames = [&](int k) {
    return link_frames(robot, q[static_cast<std::size_t>(k)], frames)(0, 3);
  };
  const auto all_segments = [&](int k) { return peer.frames(k); };
  print_row("", "all frames", compare(kConfigurations, all_frames, all_segments, kRounds),
            "at least 2.5");
}

void bench_jacobian(const Robot& robot, std::vector<Eigen::VectorXd> q, KdlArm& peer) {
  const auto ours = [&](int k) { return jacobian(robot, q[static_cast<std::size_t>(k)])(0, 0); };
  const auto theirs = [&](int k) { return peer.jacobian(k); };
  print_row("", "Jacobian", compare(kConfigurations, ours, theirs, kRounds), "at least 10");
  compare_alternately("Jacobian, in turn", q, peer, ours, theirs);
}

// All configurations in one call, compared with as many single calls of Armlet.
void bench_batch(const Robot& robot, const std::vector<Eigen::VectorXd>& q) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  std::vector<double> columns(n * kConfigurations), poses(12 * kConfigurations),
      jacobians(6 * n * kConfigurations);
  for (std::size_t k = 0; k < kConfigurations; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      columns[i * kConfigurations + k] = q[k][static_cast<Eigen::Index>(i)];
    }
  }
  const auto one_pose = [&](int k) { return forward(robot, q[static_cast<std::size_t>(k)])(0, 3); };
  const auto one_jacobian = [&](int k) {
    return jacobian(robot, q[static_cast<std::size_t>(k)])(0, 0);
  };
  const auto row = [](const std::string& what, Times times, const char* target) {
    times.ours /= kConfigurations;
    print_row("", what.c_str(), times, target);
  };
  for (const auto& [set, name] : kSets) {
    if (!is_supported(set)) continue;
    const auto all_poses = [&](int k) {
      forward_batch(robot, columns, poses, set);
      return poses[static_cast<std::size_t>(k)];
    };
    const auto all_jacobians = [&](int k) {
      jacobian_batch(robot, columns, jacobians, set);
      return jacobians[static_cast<std::size_t>(k)];
    };
    row(std::string("poses, ") + name, compare({1, kConfigurations}, all_poses, one_pose, kRounds),
        set == InstructionSet::kAvx2 ? "own; at least 4" : "own");
    row(std::string("Jacobians, ") + name,
        compare({1, kConfigurations}, all_jacobians, one_jacobian, kRounds), "own");
  }
}

// A few configurations in one call, compared with as many single calls, ns per configuration.
void bench_few(const Robot& robot, const std::vector<Eigen::VectorXd>& q) {
  const std::size_t n = static_cast<std::size_t>(robot.n());
  for (const std::size_t count : {1, 2, 3, 4, 5, 8, 11, 16}) {
    const int batches = kConfigurations / static_cast<int>(count);
    const auto of = [&](int k, std::size_t i) -> const Eigen::VectorXd& {
      return q[static_cast<std::size_t>(k) * count + i];
    };
    std::vector<std::vector<double>> columns(static_cast<std::size_t>(batches));
    for (int k = 0; k < batches; ++k) {
      for (std::size_t i = 0; i < n * count; ++i) {
        columns[static_cast<std::size_t>(k)].push_back(
            of(k, i % count)[static_cast<Eigen::Index>(i / count)]);
      }
    }
    std::vector<double> poses(12 * count), jacobians(6 * n * count);
    const auto all_poses = [&](int k) {
      forward_batch(robot, columns[static_cast<std::size_t>(k)], poses);
      return poses[0];
    };
    const auto all_jacobians = [&](int k) {
      jacobian_batch(robot, columns[static_cast<std::size_t>(k)], jacobians);
      return jacobians[0];
    };
    const auto single_poses = [&](int k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) sum += forward(robot, of(k, i))(0, 3);
      return sum;
    };
    const auto single_jacobians = [&](int k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) sum += jacobian(robot, of(k, i))(0, 0);
      return sum;
    };
    const auto row = [&](const char* what, const auto& all, const auto& one) {
      Times times = compare(batches, all, one, kRounds);
      times.ours /= static_cast<double>(count);
      times.theirs /= static_cast<double>(count);
      print_row("", (what + std::to_string(count)).c_str(), times, "own; at least 1");
    };
    row("poses, batch of ", all_poses, single_poses);
    row("Jacobians, batch of ", all_jacobians, single_jacobians);
  }
}

// The number of iterations per start with which the peer is fastest, among those with which it
// finds most solutions; its default of 500 wastes time on starts that do not converge.
int best_iterations(KdlArm& peer, const std::vector<double>& start) {
  int best = 0, best_found = -1;
  double best_time = 0.0;
  for (const int iterations : {20, 30, 50, 100, 500}) {
    int found = 0;
    auto work = [&](int k) {
      found += peer.solve(k, start, kTolerance, iterations, kStarts);
      return 0.0;
    };
    const double time = nanoseconds_per_call(200, work);
    if (found > best_found || (found == best_found && time < best_time)) {
      best = iterations;
      best_found = found;
      best_time = time;
    }
  }
  return best;
}

// All solutions, and the time of the kernel alone on each instruction set.
void bench_closed_form(const Robot& robot, const std::vector<Eigen::Isometry3d>& goals,
                       KdlArm& peer) {
  const ClosedForm& closed = closed_form(robot);
  if (!closed.exists()) return;
  const Eigen::VectorXd middle = 0.5 * (robot.lower() + robot.upper());
  const auto goal = [&](int k) -> const Eigen::Isometry3d& {
    return goals[static_cast<std::size_t>(k)];
  };
  const auto one_pose = [&](int k) { return peer.pose(k); };
  const auto row = [&](const std::string& what, const auto& work, const char* target) {
    const Times times = compare(kConfigurations, work, one_pose, kRounds);
    std::printf("%-10s %-24s %10.1f %10.1f %8.2f poses of KDL  %s\n", "", what.c_str(), times.ours,
                times.theirs, times.ours / times.theirs, target);
  };
  int solutions = 0;
  const auto all_solutions = [&](int k) {
    const int count = count_solutions(closed, goal(k), middle);
    solutions += count;
    return static_cast<double>(count);
  };
  row("inverse, all solutions", all_solutions, robot.n() == 6 ? "at most 2.5" : "");
  std::printf("%-10s   %.1f solutions\n", "", solutions / (1.0 * kRounds * kConfigurations));
  const auto form = LaneForm::make(closed.kind(), canonical_rows(robot.chain(), closed.reversed()),
                                   robot.chain());
  if (!form) return;
  for (const auto& [set, name] : kSets) {
    if (!is_supported(set)) continue;
    ClosedLanes lanes;
    const auto all_branches = [&, kernel = closed_kernel_for(set)](int k) {
      form->solve(goal(k), lanes, *kernel);
      return lanes.q[0][0];
    };
    row(std::string("its kernel, ") + name, all_branches, "at most 2.5");
  }
}

void bench_inverse(const Robot& robot, const std::vector<Eigen::VectorXd>& q, KdlArm& peer) {
  const Eigen::VectorXd middle = 0.5 * (robot.lower() + robot.upper());
  const std::vector<double> start(middle.begin(), middle.end());
  const IkOptions options{.seed = middle,
                          .choice = IkChoice::kFirst,
                          .method = IkMethod::kNumeric,
                          .position_tolerance = kTolerance,
                          .rotation_tolerance = kTolerance,
                          .starts = kStarts,
                          .diagnose = false};
  std::vector<Eigen::Isometry3d> goals;
  for (const Eigen::VectorXd& configuration : q) {
    goals.push_back(forward(robot, configuration));
    peer.add_goal(to_plain(goals.back()));
  }
  const int iterations = best_iterations(peer, start);
  int found_ours = 0, found_theirs = 0, calls = 0;
  const auto ours = [&](int k) {
    const IkResult result = solve_ik(robot, goals[static_cast<std::size_t>(k)], options);
    found_ours += result.ok();
    ++calls;
    return result.q[0];
  };
  const auto theirs = [&](int k) {
    const bool found = peer.solve(k, start, kTolerance, iterations, kStarts);
    found_theirs += found;
    return found ? 1.0 : 0.0;
  };
  const Times times = compare(kConfigurations, ours, theirs, 3);
  print_row("", "inverse, from mid-range", times, "at least 20");
  std::printf("%-10s   found %.2f %%, KDL %.2f %% with %d iterations per start\n", "",
              100.0 * found_ours / calls, 100.0 * found_theirs / calls, iterations);
  bench_closed_form(robot, goals, peer);
}

void bench_arm(const Robot& robot) {
  KdlArm peer = make_peer(robot);
  const std::vector<Eigen::VectorXd> q = random_configurations(robot);
  for (const Eigen::VectorXd& configuration : q) peer.add_configuration(configuration.data());
  check_agreement(robot, q, peer);
  bench_forward(robot, q, peer);
  bench_jacobian(robot, q, peer);
  bench_batch(robot, q);
  bench_few(robot, q);
  bench_inverse(robot, q, peer);
}

}  // namespace
}  // namespace armlet::bench

// bench_kinematics [ROBOT...]
int main(int count, char** arguments) {
  for (const std::string& name : armlet::bench::begin_comparison(count, arguments)) {
    const auto robot = armlet::make_robot(name);
    if (robot) armlet::bench::bench_arm(*robot);
  }
}
