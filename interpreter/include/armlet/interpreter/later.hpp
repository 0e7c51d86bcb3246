#pragma once
// What the language reference describes and nothing stands behind yet: how messages call it
// (E0199).

#include <string>
#include <string_view>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// What a program has to wait for that calls a function of the tables with nothing behind it yet:
// "`camera`" of the row "camera{}", or what its help says.
[[nodiscard]] inline std::string later_feature(const NativeFunction& function) {
  if (!function.help.empty()) return std::string(function.help);
  return '`' + std::string(function.name.substr(0, function.name.find_first_of("[{("))) + '`';
}

}  // namespace armlet
