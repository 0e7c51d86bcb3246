// What happens by itself to robots that move: hands that are pressed too hard, objects that slip.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "armlet/cell/contacts.hpp"

namespace armlet {

// A hand, a finger, or the links of an arm, that a motion presses harder than the hand can stand.
//
// force   when it became too much, N; most: that it can stand, N.
// with_friction  the sum of all contacts with friction of full size, N.
// finger  of a hand with fingers, from 0; -1: not one of these.
// by      what of the robot presses hardest, and on which object; of a finger the object alone. Not
//         of_hand: the force is that of all links.
struct HandOverload {
  std::int64_t t_ns = 0;
  double force = 0.0;
  double most = 0.0;
  double with_friction = 0.0;
  int finger = -1;
  Press by{};
};

// What is known ahead of a robot that moves, as long as nothing but time changes.
//
// sure_ns   up to this instant nothing happens but what is due; -1: it is not known.
// overload  due at its t_ns. slips_ns, carried: when fingers let go, and the part they carry then.
struct Foresight {
  std::int64_t sure_ns = -1;
  std::optional<HandOverload> overload{};
  std::optional<std::int64_t> slips_ns{};
  double carried = 1.0;

  // The first of what is due.
  [[nodiscard]] std::optional<std::int64_t> due_ns() const {
    if (!overload) return slips_ns;
    return slips_ns ? std::min(*slips_ns, overload->t_ns) : overload->t_ns;
  }
};

// The force that a motion may reach: what the hand can stand, or what it is pressed with already
// where the motion begins, friction of full size included, so that it can be moved away. The same
// holds for the links.
struct PressLimit {
  int motion = -1;
  std::array<double, 2> most{};  // of the hand, of the links
};

}  // namespace armlet
