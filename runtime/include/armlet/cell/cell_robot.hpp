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

// A robot of the cell: what it is and the state it is in.
//
// motion    what it executes; nothing while it stands still.
// loaded    the model with the payload and with what its hand carries: the arm of dynamics. It is
//           `model` itself while nothing with a mass is carried.
// forces    what the motors give while the robot moves under forces; empty otherwise.
// held      name of the object its hand is closed on; empty if none.
// p_picked  where that object was when it was picked up, in the world.
// on        of a hand with fingers and of its fingers: the arm whose flange carries them, in the
//           frame of which their models have T_world_base. -1: it stands in the world.
// hand      of a finger: its hand. -1: it is none.
// fingers   of a hand, in order.
// force     of a hand: that a finger presses with at most, N.
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
