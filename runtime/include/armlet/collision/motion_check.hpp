// Collision checks of motions: certain for the whole motion, not for samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "armlet/collision/arm_solids.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Bodies with a smaller overlap count as touching: surfaces are a little soft, and a tool follows a
// line only to a few micrometres.
inline constexpr double kSoft = 1e-4;  // m

// A body that is deeper in another one than this does not merely touch it or lie on it.
inline constexpr double kPressed = 0.010;  // m

// An arm that moves, or is at rest, with all that it carries.
//
// motion  from `from` on, s; after its end the arm is at rest. Not owned, like the robot.
struct ArmInMotion {
  const Robot* robot = nullptr;
  const Trajectory* motion = nullptr;
  double from = 0.0;
  std::vector<ArmSolid> solids{};
};

// A body of a scene: solid `index` of an arm, or of the fixed bodies.
struct BodyRef {
  static constexpr int kFixed = -1;
  int arm = kFixed;
  int index = 0;
};

// leaving  the two may touch at the start, up to kPressed deep: they are checked from the instant
//          at which they are 1 mm apart, or 1 mm deeper.
struct CheckedPair {
  BodyRef a;  // of an arm; of the same arm as b, on the frame farther out
  BodyRef b;
  bool leaving = false;
};

struct MotionScene {
  std::vector<ArmInMotion> arms{};
  std::vector<Solid> fixed{};
  std::vector<CheckedPair> pairs{};
  double duration = 0.0;  // s
};

// Two bodies that collide.
//
// pair       of MotionScene::pairs.
// t          the first instant of an overlap of more than kSoft, s.
// depth      the largest from there on, m, and when, s. Exact to a few micrometres; if the depth is
//            constant for long, at least kSoft less. at_least: it may be larger, as of meshes that
//            are not convex (is_whole_depth).
// p_world    position of that overlap.
// higher     height by which the first body would have to pass higher to stay clear of the second,
//            m; negative: more than a metre. As certain as the check itself if the second body is
//            at rest.
// at_end     they still overlap when the motion ends.
struct Meeting {
  std::size_t pair = 0;
  double t = 0.0;
  double depth = 0.0;
  bool at_least = false;
  double t_deepest = 0.0;
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  double higher = 0.0;
  bool at_end = false;
};

// meetings    one for each pair that collides, in order of time.
// resolution  m: every overlap deeper than kSoft plus this is found, however short. It is 0.05 mm,
//             and more only for motions that stay within it of a body for very long.
// looks       number of poses at which distances were computed.
struct MotionCheck {
  std::vector<Meeting> meetings{};
  double resolution = 0.0;
  int looks = 0;
};

// An interval of the motion is free of collisions of a pair if no point of it can travel as far in
// it as the distance between the two; other intervals are halved. Bounds on joint travel follow
// from the polynomials of the motion.
//
// throws  ArgumentError for a motion without one path for each joint of its arm, and a pair of a
//         body that does not exist.
// source  F. Schwarzer, M. Saha, J.-C. Latombe, Adaptive dynamic collision checking for single and
//         multiple articulated robots in complex environments, IEEE Transactions on Robotics 21,
//         2005.
MotionCheck check_motion(const MotionScene& scene);

// A pair of a scene that is nearer than its clearance, and when.
struct Nearing {
  std::size_t pair = 0;  // of MotionScene::pairs
  double t = 0.0;        // s
};

// The pairs of a motion that do not certainly keep their clearances, each once, in order of time;
// certified like check_motion. A pair that keeps 5 % more is never reported.
//
// keep    clearance of each pair, m, > 0; `leaving` is ignored.
// throws  ArgumentError as check_motion.
std::vector<Nearing> check_clearances(const MotionScene& scene, std::span<const double> keep);

}  // namespace armlet
