#pragma once

#include <array>
#include <string>

namespace armlet {

// Why the closed form of an arm has no solution at all, in terms of the arm's geometry: which point
// cannot get to its position in the goal, whatever the joint values.
//
// kTooFar    beyond the stretched arm.
// kTooNear   inside the hole that the folded arm leaves.
// kTooClose  closer to an axis than the arm's offset lets it pass.
// kTooHigh   too far along an axis.
// kOffPlane  off the plane in which the arm moves.
enum class GapKind { kNone, kTooFar, kTooNear, kTooClose, kTooHigh, kOffPlane };

// The point of the arm that cannot get there: the tool point, the point where the axes of the wrist
// (or, for an arm solved from its tool to its base, of the shoulder) meet, or the axis of a joint.
enum class GapPoint { kToolPoint, kWristCentre, kShoulderCentre, kAxis };

// miss          distance that is missing, m; the gap of subproblem 4 (circle and plane) or 3
//               (circle and sphere) of IK-Geo as a length.
// distance      demanded by the goal: from the axis `from`, along it, or from the plane, m.
// limit         the nearest distance that the arm allows, m.
// from          joint whose axis the distance is measured from, from 0; for kTooFar and kTooNear of
//               an arm without `links` it is the point where this axis meets the next.
// axis          for GapPoint::kAxis: which joint's, from 0.
// links         lengths of the two links of a planar arm, m; 0 for other structures.
// link_numbers  which links these are, from 0: link i follows joint i.
// source        A. Elias, J. Wen, IK-Geo: unified robot inverse kinematics using subproblem
//               decomposition, Mech. Mach. Theory 209, 2025.
struct ReachGap {
  GapKind kind = GapKind::kNone;
  GapPoint point = GapPoint::kToolPoint;
  double miss = 0.0;
  double distance = 0.0;
  double limit = 0.0;
  int from = 0;
  int axis = 0;
  std::array<double, 2> links{};
  std::array<int, 2> link_numbers{};

  bool exists() const { return kind != GapKind::kNone; }
};

// "the wrist centre is 37 mm beyond a2 + a3: 902.4 mm from axis 2, and links 2 and 3 are 431.8 mm
// and 433.6 mm long"; empty if there is no gap.
std::string describe(const ReachGap& gap);

}  // namespace armlet
