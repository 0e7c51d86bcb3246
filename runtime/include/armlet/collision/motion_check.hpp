// Whether bodies meet during a motion: certain for the whole of it, not for samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "armlet/collision/arm_solids.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Bodies that overlap less count as touching: surfaces are a little soft, and a tool follows a line
// to a few micrometres.
inline constexpr double kSoft = 1e-4;  // m

// What is deeper in a body than this does not just touch it or lie on it.
inline constexpr double kPressed = 0.010;  // m

// An arm that moves, or stands, with all that it carries.
//
// motion  from `from` on, s; behind its end the arm stands. Not owned, as the robot.
struct ArmInMotion {
  const Robot* robot = nullptr;
  const Trajectory* motion = nullptr;
  double from = 0.0;
  std::vector<ArmSolid> solids{};
};

// A body of a scene: solid `index` of an arm, or of what is fixed.
struct BodyRef {
  static constexpr int kFixed = -1;
  int arm = kFixed;
  int index = 0;
};

// leaving  the two may touch at the start, up to kPressed deep: they are checked from where they
//          have come 1 mm apart, or 1 mm deeper.
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

// Two bodies that meet.
//
// pair       of MotionScene::pairs.
// t          when they begin to overlap by more than kSoft, s.
// depth      the deepest from there on, m, and when, s: to a few micrometres, and to kSoft or not
//            below it where bodies stay equally deep for long; at_least: it may be more, as of
//            meshes that are not convex (is_whole_depth).
// p_world    where that is.
// higher     how far the first body would have to pass higher to stay clear of the second, m;
//            negative: more than a metre. Certain as the meetings are where the second one stands.
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

// meetings    one for each pair that meets, in order of time.
// resolution  m: no overlap deeper than this and kSoft together is missed, however short. It is
//             0.05 mm, and more only for motions that stay within it of a body for very long.
// looks       how many positions were looked at.
struct MotionCheck {
  std::vector<Meeting> meetings{};
  double resolution = 0.0;
  int looks = 0;
};

// A stretch of the motion is free of a pair if no point of it can travel as far as the gap between
// the two; other stretches are halved. How far joints go follows from the polynomials of the
// motion.
//
// throws  ArgumentError for a motion that has not one path for each joint of its arm, and a pair
//         that names no body.
// source  F. Schwarzer, M. Saha, J.-C. Latombe, Adaptive dynamic collision checking for single and
//         multiple articulated robots in complex environments, IEEE Transactions on Robotics 21,
//         2005.
MotionCheck check_motion(const MotionScene& scene);

// When a pair of a scene is nearer than it may be.
struct Nearing {
  std::size_t pair = 0;  // of MotionScene::pairs
  double t = 0.0;        // s
};

// The pairs of a motion that are not certain to keep their clearances, each once, in order of time;
// certified as check_motion certifies that bodies do not meet. A pair that keeps 5 % more is never
// reported.
//
// keep    of each pair, m, > 0; `leaving` does not count.
// throws  ArgumentError as check_motion.
std::vector<Nearing> check_clearances(const MotionScene& scene, std::span<const double> keep);

}  // namespace armlet
