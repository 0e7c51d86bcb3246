// The data of a robot that are needed to draw it.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Unit of a joint's position; speeds and accelerations are per second and per second squared.
enum class JointUnit { kRadian, kMetre };

// A joint and the link that it moves. With q its position, the frame of the link in the frame of
// the link before, or in the base for the first joint, is
//
//   T_before_joint M(q) T_joint_link,
//
// M(q) the rotation by q about z (kRadian) or the translation by q along z (kMetre).
//
// lower, upper  limits of the position, rad or m.
// max_speed     rad/s or m/s.
// mesh          file of the link's shape, in the frame of the link; empty: none.
struct JointInfo {
  JointUnit unit = JointUnit::kRadian;
  double lower = 0.0;
  double upper = 0.0;
  double max_speed = 0.0;
  Eigen::Isometry3d T_before_joint = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_joint_link = Eigen::Isometry3d::Identity();
  std::string mesh;
};

// A link of a robot with mimic joints: it moves as `moves` describes, with the value ratio q +
// offset, where q is the value of joint `joint`, from 0. Its limits are those of that value.
struct RowInfo {
  JointInfo moves;
  int joint = 0;
  double ratio = 1.0;
  double offset = 0.0;
};

// What is mounted at the flange, which is the frame of the last link.
//
// kind    "none", "gripper", "suction cup", "point" or "fingers".
// stroke  widest opening of a gripper, m.
// radius  of a suction cup, m.
// length  from the flange to the end of the tool along z, m.
// T_flange_tool  the tool point.
struct ToolInfo {
  std::string kind = "none";
  double stroke = 0.0;
  double radius = 0.0;
  double length = 0.0;
  Eigen::Isometry3d T_flange_tool = Eigen::Isometry3d::Identity();
};

// The shape of a link for drawing. Joint `link`, from 1, moves it; its pose is before T_joint_link.
//
// glb    bytes of a GLB, shared with the mesh of the link; never null.
// T_glb  from the coordinates of the file, z up, to that frame.
// is_drawn, collides  whether it is a shape for drawing, and one for collision checks.
struct LinkPicture {
  int link = 1;
  std::shared_ptr<const std::string> glb;
  Eigen::Affine3d T_glb = Eigen::Affine3d::Identity();
  bool is_drawn = true;
  bool collides = true;
};

// A robot of the run, as needed to draw it. Later events use its index in RunInfo.
//
// joints    joint i moves link i, unless there are rows.
// rows      one for each link of an arm with mimic joints; else empty.
// home      of each joint, rad or m.
// on        the robot that carries the base, in whose flange T_world_base is then; -1: none.
// pictures  replace the shapes of their links.
struct RobotInfo {
  std::string name;
  std::vector<JointInfo> joints;
  std::vector<RowInfo> rows{};
  std::vector<double> home;
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  int on = -1;
  ToolInfo tool;
  std::vector<LinkPicture> pictures;

  std::size_t link_count() const { return rows.empty() ? joints.size() : rows.size(); }
  // The joint that moves link i, from 0.
  const JointInfo& link(std::size_t i) const { return rows.empty() ? joints[i] : rows[i].moves; }
};

}  // namespace armlet
