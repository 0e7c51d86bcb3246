#pragma once
// What every function that makes a robot has in common.

#include <string_view>

#include "armlet/interpreter/native.hpp"
#include "armlet/model/robot.hpp"

namespace armlet::bind {

// Puts a robot into the cell and gives its handle; R0630 if the cell refuses it.
Signal add_robot(Vm& vm, Slot* args, Robot robot);

// The robot with what every such function accepts: base, tool and a name, all optional.
Robot finished(Robot robot, Slot base, Slot tool, Slot name);

// throws  ArgumentError for another word than "standard" or "modified".
DhConvention convention_of(std::string_view word);

}  // namespace armlet::bind
