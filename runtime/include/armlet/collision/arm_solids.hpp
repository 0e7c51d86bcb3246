// An arm as bodies.
#pragma once

#include <vector>

#include "armlet/collision/solid.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// A body fixed to an arm.
//
// frame   0: the base; k: the frame after joint k, of link_frames.
// solid   with its T in that frame.
// still   a body round about the first axis, on which it turns, or of the base: it stays where it
//         is.
// given   its shape is that of a description or a mesh, not one made from the joint table.
struct ArmSolid {
  int frame = 0;
  LinkShapeRole role = LinkShapeRole::kLink;
  Solid solid{};
  bool still = false;
  bool given = false;
};

// What is the hand, for the rules about grasping.
[[nodiscard]] inline bool is_hand(LinkShapeRole role) {
  return role == LinkShapeRole::kTool || role == LinkShapeRole::kFingerLeft ||
         role == LinkShapeRole::kFingerRight;
}

// Worked out once for an arm: `robot.derived<ArmSolids>()`. Links and bases that have meshes or
// simple bodies are these, and a base without them is none: the column that it may be drawn as is
// not known to be there. The other bodies are those of link_shapes, without the rings that only
// mark joints, and rods of sliding joints only up to the next frame. The end of an arm without a
// hand of a length of its own is a point in this table, around which things are taken; no hand is
// drawn for it there that could be right. What turns and slides on the last axis is as thin as a
// stick then, and the other links leave room for a hand of 150 mm. A tool that is a point alone is
// a needle from the flange to it.
class ArmSolids {
 public:
  using FromShape = void;
  explicit ArmSolids(const Robot& robot);

  [[nodiscard]] const std::vector<ArmSolid>& solids() const { return solids_; }

  // The link that the last one is a neighbour of: frames before it can be hit by what the hand
  // carries. Links are neighbours across all joints that turn and slide on one axis.
  [[nodiscard]] int neighbour_of_last() const { return neighbour_of_last_; }

  // Whether the end of the arm is a stick.
  [[nodiscard]] bool is_bare() const { return is_bare_; }

  // The same bodies, those from the table half as thick: what the arm is compared with itself by.
  [[nodiscard]] const std::vector<ArmSolid>& slim() const { return slim_; }

  // Where the arm stands, in the frame of its base: the column made from its joint table. It is
  // compared with the columns of other arms alone.
  [[nodiscard]] const std::vector<Solid>& pedestal() const { return pedestal_; }

 private:
  std::vector<ArmSolid> solids_;
  std::vector<ArmSolid> slim_;
  std::vector<Solid> pedestal_;
  int neighbour_of_last_ = 0;
  bool is_bare_ = false;
};

}  // namespace armlet
