// An arm as bodies, and which of them can collide with each other.
#pragma once

#include <utility>
#include <vector>

#include "armlet/collision/solid.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// A body fixed to an arm.
//
// frame   0: the base; k: the frame after joint k, of link_frames.
// solid   with its T in that frame.
// still   a body round about the first axis, on which it turns: it stays where it is.
struct ArmSolid {
  int frame = 0;
  LinkShapeRole role = LinkShapeRole::kLink;
  Solid solid{};
  bool still = false;
};

// What is the hand, for the rules about grasping.
[[nodiscard]] inline bool is_hand(LinkShapeRole role) {
  return role == LinkShapeRole::kTool || role == LinkShapeRole::kFingerLeft ||
         role == LinkShapeRole::kFingerRight;
}

// Worked out once for an arm: `robot.derived<ArmSolids>()`. Links that have meshes or simple bodies
// are these. The other bodies are those of link_shapes, without the rings that only mark joints,
// and rods of sliding joints only up to the next frame. The end of an arm without a hand of a
// length of its own is a point in this table, around which things are taken; no hand is drawn for
// it there that could be right. What turns and slides on the last axis is as thin as a stick then,
// and the other links leave room for a hand of 150 mm. A tool that is a point alone is a needle
// from the flange to it.
class ArmSolids {
 public:
  explicit ArmSolids(const Robot& robot);

  [[nodiscard]] const std::vector<ArmSolid>& solids() const { return solids_; }

  // The link that the last one is a neighbour of: frames before it can be hit by what the hand
  // carries. Links are neighbours across all joints that turn and slide on one axis.
  [[nodiscard]] int neighbour_of_last() const { return neighbour_of_last_; }

  // Whether the end of the arm is a stick.
  [[nodiscard]] bool is_bare() const { return is_bare_; }

  // The same bodies, half as thick: what the arm is compared with itself by.
  [[nodiscard]] const std::vector<ArmSolid>& slim() const { return slim_; }

  // Pairs of its own bodies that a motion has to be checked for, first.frame > second.frame. Left
  // out are those of one link and of neighbouring ones, those with joints of parallel axes alone
  // between them (a table does not tell whether the links lie side by side), those that overlap at
  // home or in most of many random positions of the joints (there the shapes are coarser than the
  // arm), and those that stay far apart in all of them.
  [[nodiscard]] const std::vector<std::pair<int, int>>& own_pairs() const { return own_pairs_; }

 private:
  std::vector<ArmSolid> solids_;
  std::vector<ArmSolid> slim_;
  std::vector<std::pair<int, int>> own_pairs_;
  int neighbour_of_last_ = 0;
  bool is_bare_ = false;
};

}  // namespace armlet
