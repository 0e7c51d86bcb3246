#pragma once
// Collisions of motions in messages.

#include <span>
#include <string_view>
#include <vector>

#include "armlet/control/motion_checks.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The function that closes fingers, which are meant to touch objects.
inline constexpr std::string_view kCloseHand = "closeHand";

// Reports, as `with (collisions:)` requests, the collisions of this motion of a finger: as advice,
// or as R0614. Returns collisions that are not certain yet.
//
// beside  as for find_collisions.
Answer<std::vector<PossibleCollision>> check_finger_collisions(
    Vm& vm, const MoveCall& call, const Trajectory& motion, std::span<const MotionBeside> beside);

// Advice about a collision of a motion with this duration, once for each pair of bodies and call of
// the program.
void advise_collision(Vm& vm, const MoveCall& call, const CellCollision& met, double duration);

// Reports those of the possible collisions that have happened, when the motion with that number has
// ended.
void report_collisions(Vm& vm, const MoveCall& call, int motion,
                       const std::vector<PossibleCollision>& possible);

// R0614 for a collision of a motion with this duration.
Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration);

}  // namespace armlet::bind
