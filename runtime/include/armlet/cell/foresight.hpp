// Events of moving robots without a command: overloaded grippers, objects that slip.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "armlet/cell/contacts.hpp"

namespace armlet {

// An overload: a motion presses a gripper, a finger or the links of an arm harder than the
// gripper's limit.
//
// force   at the instant of overload, N; most: the limit, N.
// with_friction  the sum of all contacts with friction of full size, N.
// finger  of a hand with fingers, from 0; -1: not a finger.
// by      the body of the robot with the largest force, and the object; of a finger the object
//         alone. Without of_hand, the force is that of all links.
struct HandOverload {
  std::int64_t t_ns = 0;
  double force = 0.0;
  double most = 0.0;
  double with_friction = 0.0;
  int finger = -1;
  Press by{};
};

// What is known about the future of a moving robot, as long as only time changes.
//
// sure_ns   up to this instant nothing happens except what is due; -1: nothing is known.
// overload  due at its t_ns. slips_ns, carried: when fingers release, and the part of the weight
//           that they carry then.
struct Foresight {
  std::int64_t sure_ns = -1;
  std::optional<HandOverload> overload{};
  std::optional<std::int64_t> slips_ns{};
  double carried = 1.0;

  // The first of the events that are due.
  [[nodiscard]] std::optional<std::int64_t> due_ns() const {
    if (!overload) return slips_ns;
    return slips_ns ? std::min(*slips_ns, overload->t_ns) : overload->t_ns;
  }
};

// The largest force allowed in a motion: the gripper's limit, or the force at the start of the
// motion if that is larger (friction of full size included), so that a robot can move out of a
// contact. The same rule holds for the links.
struct PressLimit {
  int motion = -1;
  std::array<double, 2> most{};  // of the gripper, of the links
};

}  // namespace armlet
