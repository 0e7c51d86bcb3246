#pragma once

#include "chain/batch_arm.hpp"

// Arguments and results of the kernels of closed forms; plain data only, because sources for larger
// instruction sets include it.
namespace armlet {

inline constexpr unsigned kSolutions = 8;  // of an arm of six joints to reach a pose
inline constexpr unsigned kSixJoints = 6;

// The families that have kernels (ClosedFormKind).
enum class LaneFamily : unsigned char { kSphericalParallel, kSphericalMeeting, kThreeParallel };

// The angle between two axes.
struct PlainAngle {
  double c, s;
};

// Two links in a plane, the first along x.
struct PlanarLinks {
  double l, m_l;             // first link; length of the second with the sign of the first
  PlainAngle m_back;         // the direction of the second rotated back, with that sign
  double scale;              // 1/(2 |l| |m|); infinite without such links
  double sum2, difference2;  // squares of the sum and the difference of their lengths
};

// Axes 1 and 2 meet: A cos x3 + B sin x3 = distance^2 - fixed.
struct MeetingAxes {
  double A, B, fixed;
};

// An arm of six revolute joints, prepared for its kernel: the numbers of CanonicalRows and
// constants computed from them.
struct ClosedArm {
  LaneFamily family;
  PlainAngle alpha[kSixJoints];  // before each joint
  double a[kSixJoints], h[kSixJoints];
  double point[3];  // intersection of the last axes, after joint 3 or 4
  double height;    // of that point along the parallel axes
  PlanarLinks links;
  MeetingAxes meeting;
  double slack;       // amount by which a squared sine may be below zero by rounding
  double inverse_ss;  // of the sines of the wrist's link twists
  bool right_wrist;   // they are right angles
  bool reversed;      // joint i is joint 5 - i of the arm
  double sign[kSixJoints], offset[kSixJoints];
  double walk_sign[kSixJoints];  // from angles of the rows to those of the recursion
  BatchArm walk;                 // for forward kinematics
};

// A pose by columns: axes x, y, z and origin.
struct ClosedGoal {
  double rows[12];  // in the frame of the rows
  double base[12];  // in the frame of the arm's base
};

// All solutions in lanes; solution k is the sum of kShoulderBit, kElbowBit and kWristBit.
//
// miss2  the square of the error of each solution, m^2 + rad^2, found by forward kinematics; NaN
//        for a solution that does not exist.
struct alignas(64) ClosedLanes {
  double q[kSixJoints][kSolutions];  // in the order of the arm, within half a revolution of 0
  double miss2[kSolutions];
};

// returns  false if the pose is so near to a boundary (arm stretched, wrist straight, on the first
//          axis) that the functions with branches are needed.
using ClosedKernel = bool(const ClosedArm& arm, const ClosedGoal& goal, ClosedLanes& out);
extern ClosedKernel* const kBaselineClosed;
#if defined(__x86_64__)
extern ClosedKernel* const kAvx2Closed;
extern ClosedKernel* const kAvx512Closed;
#else  // other processors never use these (is_supported)
inline ClosedKernel* const& kAvx2Closed = kBaselineClosed;
inline ClosedKernel* const& kAvx512Closed = kBaselineClosed;
#endif

}  // namespace armlet
