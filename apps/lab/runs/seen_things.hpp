#pragma once
// Data of the cell at an instant that a page draws, besides arms and objects.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "armlet/cell/cell.hpp"

namespace armlet::lab {

// A frame with a name.
//
// object  that carries it; empty: it is fixed in the world.
// T       its pose in the frame of the object, or in the world.
struct SeenFrame {
  std::string name;
  std::string object;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
};

// Two bodies that touch, or the nearest ones of a robot (armlet/cell/clearance.hpp).
//
// robot, other_robot    the robot that the body belongs to or that carries it; -1: none.
// object, other_object  its name; empty: it is a part of the robot.
// body, other           "link 3 of `arm`".
// link, other_link      of a part of a robot: what joint `link` moves, counted from 1; 0: the base.
struct SeenClearance {
  int robot = -1;
  std::string object;
  int link = 0;
  std::string body;
  int other_robot = -1;
  std::string other_object;
  int other_link = 0;
  std::string other;
  double distance = 0.0;     // m, below zero if they overlap
  bool is_at_least = false;  // they may overlap by more
  bool is_felt = false;      // the tool presses into the other one: a contact force
  Eigen::Vector3d p_body = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_other = Eigen::Vector3d::Zero();
};

// A point at which a robot presses on something.
//
// robot, object  the robot, and the object that it presses on; `object` is empty if that is a body
//                of a robot.
// p, force       in the world: the point, m, and the contact force on the robot, N.
struct SeenPress {
  int robot = -1;
  std::string object;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

struct SeenThings {
  std::vector<SeenFrame> frames{};
  std::vector<SeenClearance> clearances{};
  std::vector<SeenPress> presses{};
};

[[nodiscard]] SeenThings things_of(const Cell& cell);

}  // namespace armlet::lab
