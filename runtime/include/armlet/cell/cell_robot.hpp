// A robot among others of a cell.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/cell/motion.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// A robot of the cell: its model and its state.
//
// motion    what it executes; nothing while it is at rest.
// loaded    the model with the payload and with the object in its gripper, for dynamics. It is
//           `model` itself while nothing with a mass is carried.
// forces    of the motors while the robot moves under forces; empty otherwise.
// held      name of the object in its gripper; empty if there is none.
// p_picked  position of that object when it was picked up, in the world.
// on        of a hand with fingers and of its fingers: the arm whose flange carries them.
//           T_world_base of their models is relative to that flange. -1: the base is fixed in the
//           world.
// hand      of a finger: the index of the `hand`. -1: it is not a finger.
// fingers   of a `hand`, in order.
// force     of a `hand`: the largest force with which a finger presses, N.
struct CellRobot {
  std::string name;
  std::shared_ptr<const Robot> model;  // shared with catalogues and planners; it never changes
  std::shared_ptr<const Robot> loaded{};
  Eigen::VectorXd q, qd, qdd;  // rad or m and their derivatives
  std::optional<Motion> motion{};
  int motion_id = -1;
  Eigen::VectorXd forces{};
  std::string held{};
  Eigen::Vector3d p_picked = Eigen::Vector3d::Zero();
  int on = -1;
  int hand = -1;
  std::vector<int> fingers{};
  double force = 0.0;
};

}  // namespace armlet
