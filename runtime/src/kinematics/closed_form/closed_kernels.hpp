#pragma once

#include "chain/walk_in.hpp"
#include "math/det_atan2_lanes.hpp"
#include "solution_lanes.hpp"

// The kernel of the closed forms: all solutions at once, each checked by forward kinematics; angles
// are computed at the end. Compiled once per instruction set, in sources that include nothing else;
// all give the same bits.
namespace armlet::closed {

// Sines and cosines in the order of the arm's recursion.
template <class V>
struct WalkAngles {
  V sine[kSixJoints], cosine[kSixJoints];

  [[gnu::always_inline]] explicit WalkAngles(const SolutionLanes<V>& solutions) {
    for (unsigned i = 0; i < kSixJoints; ++i) {
      const unsigned joint = solutions.arm.reversed ? kSixJoints - 1 - i : i;
      sine[joint] = solutions.x[i].s * solutions.arm.walk_sign[i];
      cosine[joint] = solutions.x[i].c;
    }
  }
};

// Three columns of the pose, computed from the tool to the base: axes x, y and the origin.
template <class V>
struct ThreeColumns {
  Parts<V> of[3];

  [[gnu::always_inline]] void rotate_z(V sine, V cosine) {
    for (Parts<V>& v : of) v.rotate_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_right_z(V sine, V cosine) {
    for (Parts<V>& v : of) v.rotate_right_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_x(double sin_alpha, double cos_alpha) {
    for (Parts<V>& v : of) v.rotate_x(all_lanes<V>(sin_alpha), all_lanes<V>(cos_alpha));
  }
};

template <class V>
[[gnu::always_inline]] inline V square_of(const Parts<V>& v, const double* goal) {
  const V x = v.x - goal[0], y = v.y - goal[1], z = v.z - goal[2];
  return x * x + y * y + z * z;
}

// The square of the error of forward kinematics. If the errors of the x and y axes are w x X and w
// x Y, the sum of their squares is at least that of w.
template <class V>
[[gnu::always_inline]] inline V miss2_of(const ClosedArm& arm, const double* goal,
                                         const WalkAngles<V>& turns) {
  const BatchArm& walk = arm.walk;
  const double* T = walk.tool;
  const auto column = [&](unsigned c) __attribute__((always_inline)) {
    return Parts<V>{all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
  };
  ThreeColumns<V> t = {{column(0), column(1), column(3)}};
  Parts<V>& p = t.of[2];
  t.rotate_z(turns.sine[5], turns.cosine[5]);
  if (walk.has_d[5]) p.z += walk.d[5];
  for (unsigned i = kSixJoints - 1; i-- > 0;) {
    if (walk.has_a[i + 1]) p.x += walk.a[i + 1];
    step_in(walk, i, turns.sine[i], turns.cosine[i], t);
    if (walk.has_d[i]) p.z += walk.d[i];
  }
  const V position = square_of(p, goal + 9);
  const V axes = square_of(t.of[0], goal) + square_of(t.of[1], goal + 3);
  return position > axes ? position : axes;
}

template <class V>
[[gnu::always_inline]] inline void store_joints(const SolutionLanes<V>& solutions, unsigned k,
                                                ClosedLanes& out) {
  constexpr double kPi = 3.14159265358979323846;
  const ClosedArm& arm = solutions.arm;
  const V none = {};
  for (unsigned i = 0; i < kSixJoints; ++i) {
    const V q = arm.sign[i] * det::atan2_lanes(solutions.x[i].s, solutions.x[i].c) - arm.offset[i];
    const V down = det::choose<V>(q > none + kPi, none - 2.0 * kPi, none);
    const V around = det::choose<V>(q <= none - kPi, none + 2.0 * kPi, down);
    store_lanes(out.q[arm.reversed ? kSixJoints - 1 - i : i] + k, q + around);
  }
}

// The signs of solution k.
constexpr double kShoulderSign[kSolutions] = {1, 1, 1, 1, -1, -1, -1, -1};
constexpr double kElbowSign[kSolutions] = {1, 1, -1, -1, 1, 1, -1, -1};
constexpr double kWristSign[kSolutions] = {1, -1, 1, -1, 1, -1, 1, -1};

template <class V>
bool closed_kernel(const ClosedArm& arm, const ClosedGoal& goal, ClosedLanes& out) {
  const FirstChoice first(arm, goal.rows);
  if (first.is_missing()) {
    for (double& miss2 : out.miss2) miss2 = __builtin_nan("");
    return true;
  }
  if (!first.exists()) return false;
  constexpr unsigned kLanes = sizeof(V) / sizeof(double);
  det::LaneBits<V> touching = {};
  for (unsigned k = 0; k < kSolutions; k += kLanes) {
    SolutionLanes<V> solutions{arm, goal.rows, load_lanes<V>(kShoulderSign + k),
                               load_lanes<V>(kElbowSign + k), load_lanes<V>(kWristSign + k)};
    if (arm.family == LaneFamily::kSphericalParallel)
      spherical_parallel(solutions, first);
    else if (arm.family == LaneFamily::kSphericalMeeting)
      spherical_meeting(solutions, first);
    else
      three_parallel(solutions, first);
    touching |= solutions.touching;
    store_lanes(out.miss2 + k, miss2_of(arm, goal.base, WalkAngles<V>(solutions)));
    store_joints(solutions, k, out);
  }
  auto any = touching[0];
  for (unsigned lane = 1; lane < kLanes; ++lane) any |= touching[lane];
  return any == 0;
}

}  // namespace armlet::closed
