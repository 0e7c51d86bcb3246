#pragma once

#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"

namespace armlet::bind {

// The printed table of a hand with fingers: for each actuated joint the joints of the mechanism
// that it drives, their ratios and ranges.
[[nodiscard]] std::string hand_table(const Robot& palm, std::string_view name);

}  // namespace armlet::bind
