// Planning and sampling of motions. The unit of the targets is one forward kinematics of the Puma
// by Orocos KDL, timed in alternation with each figure.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_line.hpp"
#include "armlet/trajectory/jerk_limited.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "bench.hpp"
#include "kdl_peer.hpp"

namespace {

long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace armlet::bench {
namespace {

constexpr int kJoints = 7;
constexpr int kCases = 1000;

// Times work(i) and KDL, and prints the time and its target as multiples of KDL's time. KDL makes
// the same number of calls in each row, so that its caches are in the same state.
template <class Work>
void row(const char* what, KdlArm& peer, Work work, double target, int calls = kCases) {
  const Times times = compare(
      {calls, kCases}, work, [&](int k) { return peer.pose(k); }, 11);
  std::printf("%-44s %12.1f ns %9.2f", what, times.ours, times.ours / times.theirs);
  if (target > 0.0) std::printf("   (target %g)", target);
  std::printf("\n");
}

struct Move {
  std::array<AxisState, kJoints> from;
  std::array<double, kJoints> to;
  std::array<AxisLimits, kJoints> limits;
};

std::vector<Move> random_moves(bool moving) {
  Random random(3);
  std::vector<Move> moves(kCases);
  for (Move& move : moves) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      move.limits[i] = {random.uniform(1.0, 3.0), random.uniform(5.0, 15.0),
                        random.uniform(50.0, 150.0)};
      move.from[i].q = random.uniform(-2.8, 2.8);
      move.to[i] = random.uniform(-2.8, 2.8);
      if (!moving) continue;
      move.from[i].v = random.uniform(-0.7, 0.7) * move.limits[i].speed;
      move.from[i].a = random.uniform(-0.3, 0.3) * move.limits[i].acceleration;
    }
  }
  return moves;
}

Trajectory curved(int joints) {
  Random random(5);
  std::vector<Eigen::VectorXd> points(6, Eigen::VectorXd(joints));
  for (Eigen::VectorXd& point : points) {
    for (double& q : point) q = random.uniform(-2.0, 2.0);
  }
  return path_through(points);
}

void bench_sampling(const char* what, const Trajectory& motion, KdlArm& peer) {
  Random random(7);
  std::vector<double> anywhere(kCases);
  for (double& t : anywhere) t = random.uniform(0.0, motion.duration());
  Eigen::VectorXd q(kJoints), qd(kJoints), qdd(kJoints);
  const auto sample = [&](double t) {
    motion.sample(t, q, qd, qdd);
    return q[0] + qd[3] + qdd[6];
  };
  const auto in_order = [&](int k) { return sample(motion.duration() * k / kCases); };
  const auto at_random = [&](int k) { return sample(anywhere[static_cast<std::size_t>(k)]); };
  const long before = allocations;
  for (int k = 0; k < kCases; ++k) in_order(k);
  std::printf("one sample of 7 joints, %s (%ld allocations)\n", what, allocations - before);
  row("  times in order", peer, in_order, 0.15);
  row("  times at random", peer, at_random, 0.15);
}

void bench_limited_jerk(bool moving, KdlArm& peer) {
  const std::vector<Move> moves = random_moves(moving);
  std::array<JerkProfile, kJoints> profiles;
  const auto plan = [&](int k) {
    const Move& move = moves[static_cast<std::size_t>(k)];
    return plan_jerk_limited(move.from, move.to, move.limits, profiles);
  };
  const auto whole = [&](int k) {
    const Move& move = moves[static_cast<std::size_t>(k)];
    const double T = plan_jerk_limited(move.from, move.to, move.limits, profiles);
    return jerk_trajectory(move.from, move.to, profiles, T).duration();
  };
  std::printf("limited jerk, 7 joints, %s\n", moving ? "from a moving start" : "from rest to rest");
  row("  plan", peer, plan, moving ? 32.0 : 6.0);
  row("  plan, as a trajectory", peer, whole, 0.0);
}

void bench_time_optimal(KdlArm& peer) {
  const Trajectory path = curved(kJoints);
  std::vector<AxisLimits> limits(kJoints, {2.0, 8.0, 80.0});
  const auto plan = [&](int k) {
    limits[0].speed = 2.0 + 1e-3 * k;
    return fastest_along(path, limits, 100).squared[50];
  };
  const auto whole = [&](int k) {
    limits[0].speed = 2.0 + 1e-3 * k;
    return time_optimal(path, limits, 100).duration();
  };
  std::printf("fastest along a path, 7 joints, %zu intervals\n",
              fastest_along(path, limits, 100).s.size() - 1);
  row("  speeds along the path", peer, plan, 100.0, 200);
  row("  as a trajectory that keeps the limits", peer, whole, 0.0, 50);
}

void bench_line(const char* name, const Eigen::VectorXd& q0, KdlArm& peer) {
  const Robot robot = *make_robot(name);
  LineMove move{.q0 = q0, .T_world_goal = forward(robot, q0), .tool_speed = 0.25};
  move.T_world_goal.translation().y() += 0.5;
  const LinePlan plan = plan_line(robot, move);
  std::printf("straight line of 0.5 m, %s: %s, %zu pieces\n", name, plan.ok() ? "ready" : "REFUSED",
              plan.ok() ? plan.motion.trajectory->joint(0).segments.size() : 0);
  const auto line = [&](int) { return plan_line(robot, move).length; };
  row("  planned and verified (target 1 ms)", peer, line, 0.0, 10);
}

}  // namespace
}  // namespace armlet::bench

int main() {
  using namespace armlet::bench;
  const armlet::Robot puma = *armlet::make_robot("puma560");
  KdlArm peer = make_peer(puma);
  armlet::Random random(1);
  for (int k = 0; k < kCases; ++k) {
    Eigen::VectorXd q(6);
    for (int i = 0; i < 6; ++i) q[i] = random.uniform(puma.lower()[i], puma.upper()[i]);
    peer.add_configuration(q.data());
  }
  std::printf("%-44s %15s %9s\n", "", "time", "x KDL FK");
  armlet::MoveRequest request{.q0 = Eigen::VectorXd::Zero(kJoints),
                              .q1 = Eigen::VectorXd::LinSpaced(kJoints, 0.3, 2.0)};
  request.limits.assign(kJoints, {2.0, 8.0, 80.0});
  const armlet::PlannerSet planners;
  for (const char* name : {"Syn", "Asyn", "SCurve", "434"}) {
    bench_sampling(name, *planners.plan(name, request).trajectory, peer);
  }
  bench_sampling("along a path", armlet::time_optimal(curved(kJoints), request.limits), peer);
  bench_limited_jerk(false, peer);
  bench_limited_jerk(true, peer);
  bench_time_optimal(peer);
  Eigen::VectorXd q0(6);
  q0 << -0.2635, -1.466, -0.6528, 0.0, -1.0228, 2.878;
  bench_line("puma560", q0, peer);
  q0 << -0.3, -1.3, 1.9, -1.1, -1.5, 0.2;
  bench_line("ur5", q0, peer);
}
