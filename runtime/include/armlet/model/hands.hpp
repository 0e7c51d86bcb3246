#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "armlet/model/tool.hpp"

namespace armlet {

// A ready-made hand: what it is for the arm that carries it, and its own joints if it has some.
struct Hand {
  std::string name;
  std::string source;
  Tool tool;
  std::optional<Mechanism> mechanism;
};

// "barrett_hand", "parallel_gripper", "suction_cup"
const std::vector<std::string_view>& hand_names();

// The hand of that name, or nothing.
std::optional<Hand> make_hand(std::string_view name);

// Barrett Hand BH8-280: four actuators (spread, f1, f2, f3) move eight joints. Fingers 1 and 2 turn
// about the palm by the spread angle, mirrored; the last link of each finger turns by a third of
// the angle of the one before it. At zero the fingers lie flat and point outwards, 1 and 2 along +y
// and 3 along -y of the palm. Tips: "tip1", "tip2", "tip3".
Mechanism make_barrett_hand();

// Franka Hand: one actuator moves two fingers apart, each by half of the opening.
Mechanism make_parallel_gripper();

}  // namespace armlet
