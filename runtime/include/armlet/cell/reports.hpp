// The reports of a cell about motions, and about events that no command caused.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "armlet/cell/foresight.hpp"

namespace armlet {

// The course of a motion, also while it is running. A motion that was stopped before its end counts
// as stopped, wherever it came to rest.
//
// halted    stopped by a request from outside of the motion.
// held_ns   of a velocity command: until when it holds; then the robot decelerates, and another
//           command may follow.
// overload  the contact force on the gripper exceeded its limit: the motion began to stop there.
enum class MotionState { kRunning, kReached, kStopped };
struct MotionReport {
  MotionState state = MotionState::kRunning;
  int robot = 0;
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;  // of a running motion: when it will end
  bool halted = false;
  std::optional<std::int64_t> held_ns{};
  std::optional<HandOverload> overload{};
};

// An event without a command.
//
// motion  the motion that ended.
// object  for kPicked, kPutDown and kSlipped; `support` is what it was put on or fell onto.
//         kSlipped: the fingers that held it carry only the part `carried` of its weight, or of its
//         weight and inertia while `moving`.
enum class CellEventKind { kMotionEnded, kPicked, kPutDown, kSlipped };
struct CellEvent {
  std::int64_t t_ns = 0;
  CellEventKind kind = CellEventKind::kMotionEnded;
  int robot = 0;
  int motion = -1;
  std::string object{};
  std::string support{};
  double carried = 0.0;
  bool moving = false;
};

}  // namespace armlet
