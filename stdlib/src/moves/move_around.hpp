#pragma once
// Searches around obstacles in messages.

#include "moves/moves.hpp"

namespace armlet::bind {

// No motion around the obstacles was found: R0643 if the start or the goal collides, R0644 or R0646
// if the search has failed.
Failed fail_no_way(Vm& vm, const MoveCall& call, const refused::NoWayAround& why);

}  // namespace armlet::bind
