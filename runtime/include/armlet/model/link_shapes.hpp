#pragma once
// The shapes that an arm is drawn as: those that its description gives, or simple ones made from
// its joint table.

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// All lie along the z axis of their frame, with their middle in its origin.
//
// kCapsule  a cylinder with half a sphere at each end; `length` is that of the cylinder alone.
// kRing     the wall of a tube, `radius` outside.
enum class LinkShapeKind { kCylinder, kCapsule, kRing, kBox };
// "cylinder", "capsule", "ring", "box".
std::string_view to_text(LinkShapeKind kind);

// kMark  a ring at the place where two links turn about or slide along each other.
enum class LinkShapeRole { kBase, kJoint, kLink, kFlange, kTool, kFingerLeft, kFingerRight, kMark };
// "base", "joint", "link", "flange", "tool", "finger_left", "finger_right", "mark".
std::string_view to_text(LinkShapeRole role);

// link  0: the base, in the frame of the base; i: what joint i - 1 moves, in the frame whose z axis
//       is that of the joint and which moves with it (before T_joint_link of JointInfo); n + 1:
//       what is fixed to the flange, in its frame.
struct LinkShape {
  int link = 0;
  LinkShapeKind kind = LinkShapeKind::kCapsule;
  LinkShapeRole role = LinkShapeRole::kLink;
  Eigen::Isometry3d T_link_shape = Eigen::Isometry3d::Identity();
  double radius = 0.0;                             // m, of all but boxes
  double length = 0.0;                             // m, the same
  double thickness = 0.0;                          // m, of rings
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // m, of boxes: along x, y and z
  bool given = false;  // by a description: drawn beside the meshes of its link, not in their place
};

// The shapes of an arm, of its base, and of the tool in its hand. Boxes, cylinders and spheres that
// were given for a link are its shapes. Other links get some from the table, also links with
// meshes, which stand in where these cannot be shown, and so does the base of an arm of which no
// shape was given at all.
//
// A link of the table runs along its own joint's
// axis to the point nearest to the next axis, across to that axis, and along it to the next joint;
// a sliding joint is a rod in a sleeve, long enough for all of its way. The fingers of a gripper
// are open. How thick things are follows from the reach of the arm.
std::vector<LinkShape> link_shapes(const Robot& robot);

// The shapes of a base made from the table alone, whatever was given: where the arm stands.
std::vector<LinkShape> pedestal_shapes(const Robot& robot);

}  // namespace armlet
