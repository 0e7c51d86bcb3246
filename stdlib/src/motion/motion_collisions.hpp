#pragma once
// What motions run into.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Whether this will be a collision shows when the move is over.
//
// guarded  the move may be stopped before, and what the hand presses into is felt.
// last     of another robot: the number of its last motion that this one was compared with;
//          nothing: the other one is no robot, or all of its motion is known.
struct PossibleCollision {
  CellCollision met;
  bool guarded = false;
  std::optional<int> last{};
};

// Fingers that close: objects are what they look for.
inline constexpr std::string_view kCloseHand = "closeHand";

// Says, as `with (collisions:)` wants it, what the robot of the call would meet on this motion: as
// advice, one for each pair and place of the program, or as R0614; inside with (avoid: true) always
// as the latter. Returns what cannot be known yet: a robot that stands may start
// in the same instant, and a guard may stop the move before.
//
// beside  as for find_collisions.
Answer<std::vector<PossibleCollision>> check_collisions(Vm& vm, const MoveCall& call,
                                                        const Trajectory& motion,
                                                        std::span<const MotionBeside> beside = {});

// Says what has come true of them, when the motion of that number is over.
void report_collisions(Vm& vm, const MoveCall& call, int motion,
                       const std::vector<PossibleCollision>& possible);

// R0614 for what a motion that takes so many seconds would meet.
Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration);

}  // namespace armlet::bind
