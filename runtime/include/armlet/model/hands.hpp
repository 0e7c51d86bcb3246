#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/model/tool.hpp"

namespace armlet {

// A ready-made gripper: the tool for the arm that carries it, and its own joints if it has some.
struct Hand {
  std::string name;
  std::string source;
  Tool tool;
  std::optional<Mechanism> mechanism;
};

// "barrett_hand", "parallel_gripper", "suction_cup"
const std::vector<std::string_view>& hand_names();

// The gripper of that name; nothing if there is none.
std::optional<Hand> make_hand(std::string_view name);

// Barrett Hand BH8-280: four actuators (spread, f1, f2, f3) move eight joints. Fingers 1 and 2
// rotate about the palm by the spread angle, mirrored; the last link of each finger rotates by a
// third of the angle of the one before it. At zero the fingers lie flat and point outwards, 1 and 2
// along +y and 3 along -y of the palm. Tips: "tip1", "tip2", "tip3".
Mechanism make_barrett_hand();

// The Barrett Hand as robots that an arm carries; their bases are in the frame of its flange.
//
// palm     four joints, spread and f1 to f3, which drive the fingers; the base of the gripper.
// fingers  chains of the joints that move them: 1 and 2 spread, bend and curl, 3 bend and curl.
// tool     of the arm that carries it: the tool point is in the middle between the fingers.
// force    the largest force with which a finger presses, N.
struct FingeredHand {
  Robot palm;
  std::vector<Robot> fingers;
  Tool tool;
  double force = 15.0;
};

// Speeds: a finger closes in 1 s, the spread takes 0.5 s; 15 N at the tip of a finger.
// source  Barrett Technology, BH8-series user manual.
FingeredHand make_barrett_robots(const std::string& name);

// Joint values of a finger, 0 to 2, from those of the palm; the same for rates.
Eigen::VectorXd finger_joints(int finger, const Eigen::VectorXd& q_palm);
// The joint of a finger that bends it, which is the one that is driven.
inline int bend_joint(int finger) { return finger < 2 ? 1 : 0; }

// Franka Hand: one actuator moves two fingers apart, each by half of the opening.
Mechanism make_parallel_gripper();

}  // namespace armlet
