#pragma once
// Settings of `with` blocks that are one of a few names.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::bind {

// The names that a setting can have; empty if it is not such a setting.
[[nodiscard]] std::vector<std::string> choices_of_setting(std::string_view setting);

}  // namespace armlet::bind
