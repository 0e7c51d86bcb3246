// Event data of shapes that are shown and are not bodies: an arrow, a text, a disk.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// The link of a DrawingInfo that is at the tool point.
inline constexpr int kDrawingTip = -1;

// A shape and what it moves with.
//
// kind     "arrow", "line", "text", "disk", "ellipsoid" or "capsule".
// size     m: length along z and width of an arrow or a line; height of a text, which faces the
//          viewer; radius of a disk, which faces along z; semi-axes of an ellipsoid; radius and
//          length of a capsule, which lies along z with a half ball beyond each end. The origin of
//          an arrow, a line and a capsule is at their start, that of other shapes in the centre.
// robot    index of the robot with which it moves; -1: none. `link`: the joint that moves its link,
//          0: its base; or kDrawingTip.
// object   name of the object with which it moves; empty: none.
// T_on_drawing  its pose in that frame, or in the world.
struct DrawingInfo {
  std::string name;
  std::string kind;
  std::array<double, 3> size{};
  std::string text;
  std::string color = "gray";
  int robot = -1;
  int link = kDrawingTip;
  std::string object;
  Eigen::Isometry3d T_on_drawing = Eigen::Isometry3d::Identity();
};

}  // namespace armlet
