// The bodies of an arm for collision checks.
#pragma once

#include <vector>

#include "armlet/collision/solid.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// A body fixed to an arm.
//
// frame   0: the base; k: the frame after joint k, of link_frames.
// solid   with its T in that frame.
// still   a part of the base, or a round body about the first axis, on which it rotates: it
//         occupies the same space in all poses.
// given   its shape is from a description or a mesh, not made from the joint table.
struct ArmSolid {
  int frame = 0;
  LinkShapeRole role = LinkShapeRole::kLink;
  Solid solid{};
  bool still = false;
  bool given = false;
};

// Whether the part belongs to the gripper, for the rules about grasping.
[[nodiscard]] inline bool is_hand(LinkShapeRole role) {
  return role == LinkShapeRole::kTool || role == LinkShapeRole::kFingerLeft ||
         role == LinkShapeRole::kFingerRight;
}

// Computed once for an arm: `robot.derived<ArmSolids>()`. Links and bases with meshes or simple
// bodies consist of these. A base without them has no body, since the column with which it may be
// drawn is an assumption. The other bodies are those of link_shapes, without the rings that only
// mark joints, and with rods of prismatic joints only up to the next frame. An arm without a
// gripper of a length of its own ends in a point, because the size of a gripper is not known. The
// parts that rotate and slide on its last axis are as thin as a rod then, and the other links leave
// room for a gripper of 150 mm. A tool that is a point alone is a thin rod from the flange to it.
class ArmSolids {
 public:
  using FromShape = void;
  explicit ArmSolids(const Robot& robot);

  [[nodiscard]] const std::vector<ArmSolid>& solids() const { return solids_; }

  // The link that counts as the neighbour of the last one: what the gripper carries can collide
  // with the frames before it. Links are neighbours across all joints that rotate and slide on one
  // axis.
  [[nodiscard]] int neighbour_of_last() const { return neighbour_of_last_; }

  // Whether the arm ends in a rod without a gripper.
  [[nodiscard]] bool is_bare() const { return is_bare_; }

  // The bodies for self-collisions: the same, with those from the table half as thick.
  [[nodiscard]] const std::vector<ArmSolid>& slim() const { return slim_; }

  // The base column made from the joint table, in the frame of the base. It is compared only with
  // the columns of other arms.
  [[nodiscard]] const std::vector<Solid>& pedestal() const { return pedestal_; }

 private:
  std::vector<ArmSolid> solids_;
  std::vector<ArmSolid> slim_;
  std::vector<Solid> pedestal_;
  int neighbour_of_last_ = 0;
  bool is_bare_ = false;
};

}  // namespace armlet
