#pragma once
// Collisions of motions.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// A collision that can be confirmed only when the move has ended.
//
// guarded  the move may be stopped before it, and contact of the tool causes a contact force.
// last     the other body is a robot: number of its last motion that was included; nullopt: the
//          other body is no robot, or its whole motion is known.
struct PossibleCollision {
  CellCollision met;
  bool guarded = false;
  std::optional<int> last{};
};

// The function that closes fingers, which are meant to touch objects.
inline constexpr std::string_view kCloseHand = "closeHand";

// Reports, as `with (collisions:)` requests, the collisions of this motion of the robot of the
// call: as advice, once for each pair of bodies and call of the program, or as R0614; inside with
// (avoid: true) always as R0614. Returns collisions that are not certain yet: a robot at rest may
// start at the same instant, and a guard may stop the move before.
//
// beside  as for find_collisions.
// beside  as for find_collisions.
Answer<std::vector<PossibleCollision>> check_collisions(Vm& vm, const MoveCall& call,
                                                        const Trajectory& motion,
                                                        std::span<const MotionBeside> beside = {});

// Reports those of them that have happened, when the motion with that number has ended.
void report_collisions(Vm& vm, const MoveCall& call, int motion,
                       const std::vector<PossibleCollision>& possible);

// R0614 for a collision of a motion with this duration.
Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration);

}  // namespace armlet::bind
