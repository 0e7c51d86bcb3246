#pragma once

#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"

namespace armlet::bind {

// A hand with fingers as it is printed: which joint of its mechanism each of its own joints drives,
// how far, and over which range.
[[nodiscard]] std::string hand_table(const Robot& palm, std::string_view name);

}  // namespace armlet::bind
