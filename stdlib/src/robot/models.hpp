#pragma once
// What every function that makes a robot has in common.

#include <string_view>

#include "armlet/model/robot.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Puts a robot into the cell; R0630 if the cell refuses it.
Answer<RobotRef> add_robot(Vm& vm, Robot robot);

// The robot with what every such function accepts: base, tool and a name, all optional.
Robot finished(Robot robot, const PosC* base, const ToolValue* tool,
               std::optional<std::string_view> name = {});

// throws  ArgumentError for another word than "standard" or "modified".
DhConvention convention_of(std::string_view word);

}  // namespace armlet::bind
