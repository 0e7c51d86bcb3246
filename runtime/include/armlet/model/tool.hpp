#pragma once

#include <limits>
#include <string_view>

namespace armlet {

// kFingers  a hand with fingers, which is a robot of its own (armlet/model/hands.hpp).
enum class ToolKind { kNone, kParallelGripper, kSuctionCup, kPoint, kFingers };

// The tool at the flange. Its tool point lies `length` along the z axis of the flange.
//
// stroke          widest opening of a gripper, m; wider objects cannot be grasped.
// length          from the flange to the tool point, m.
// force           closing force, N.
// radius          of a suction cup, m.
// max_force       limit of the contact force on the gripper, N.
// grasp_distance  largest distance from the tool point to a grasped object, m.
struct Tool {
  ToolKind kind = ToolKind::kNone;
  double stroke = 0.0;
  double length = 0.0;
  double force = 0.0;
  double radius = 0.0;
  double max_force = std::numeric_limits<double>::infinity();
  double grasp_distance = 0.005;

  bool can_grasp() const {
    return kind == ToolKind::kParallelGripper || kind == ToolKind::kSuctionCup;
  }
};

// Ready-made tools; lengths in m, forces in N. All throw ArgumentError for a stroke or radius that
// is not above zero, a negative length or a negative force.
Tool parallel_gripper(double stroke, double length = 0.120, double force = 20.0);
Tool suction_cup(double radius, double length = 0.060);
Tool point_tool(double length = 0.0);

}  // namespace armlet
