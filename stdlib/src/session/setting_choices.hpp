#pragma once
// Settings of `with` blocks that are one of a few names.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::bind {

// The names that a setting can have; none if it is no such setting.
[[nodiscard]] std::vector<std::string> choices_of_setting(std::string_view setting);

}  // namespace armlet::bind
