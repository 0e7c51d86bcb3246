#pragma once

#include "armlet/model/link.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

// All that travels with a carrier, as one rigid body seen from its frame: what the hand holds and
// what rests on it.
Payload carried_load(const World& world, int carrier);

}  // namespace armlet
