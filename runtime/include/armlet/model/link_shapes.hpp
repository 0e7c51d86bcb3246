#pragma once
// The shapes with which an arm is drawn: those of its description, or simple ones made from its
// joint table.

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// All lie along the z axis of their frame, centred in its origin.
//
// kCapsule  a cylinder with half a sphere at each end; `length` is that of the cylinder alone.
// kRing     the wall of a tube, `radius` outside.
enum class LinkShapeKind { kCylinder, kCapsule, kRing, kBox };
// "cylinder", "capsule", "ring", "box".
std::string_view to_text(LinkShapeKind kind);

// kMark  a ring where two links rotate about or slide along each other.
enum class LinkShapeRole { kBase, kJoint, kLink, kFlange, kTool, kFingerLeft, kFingerRight, kMark };
// "base", "joint", "link", "flange", "tool", "finger_left", "finger_right", "mark".
std::string_view to_text(LinkShapeRole role);

// link  0: the base, in the frame of the base; i: the link that joint i - 1 moves, in the frame
//       that moves with the joint and has its axis as z (before T_joint_link of JointInfo); n + 1:
//       parts fixed to the flange, in its frame.
struct LinkShape {
  int link = 0;
  LinkShapeKind kind = LinkShapeKind::kCapsule;
  LinkShapeRole role = LinkShapeRole::kLink;
  Eigen::Isometry3d T_link_shape = Eigen::Isometry3d::Identity();
  double radius = 0.0;                             // m, of all but boxes
  double length = 0.0;                             // m, the same
  double thickness = 0.0;                          // m, of rings
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // m, of boxes: along x, y and z
  bool given = false;  // by a description: drawn in addition to the meshes of its link
};

// The shapes of an arm, its base and its tool. Boxes, cylinders and spheres that were given for a
// link are its shapes. Other links get shapes made from the table. So do links with meshes, for
// viewers that cannot show the meshes, and the base of an arm for which no shape was given at all.
//
// A link made from the table runs along its own joint's axis to the point nearest to the next axis,
// across to that axis, and along it to the next joint. A prismatic joint is a rod in a sleeve, long
// enough for its whole range. The fingers of a gripper are open. Thicknesses follow from the reach
// of the arm.
std::vector<LinkShape> link_shapes(const Robot& robot);

// The shapes of a base made from the table alone, whatever was given: the pedestal of the arm.
std::vector<LinkShape> pedestal_shapes(const Robot& robot);

}  // namespace armlet
