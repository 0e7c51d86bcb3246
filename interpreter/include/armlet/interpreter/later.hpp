#pragma once
// What the language reference describes and nothing stands behind yet: how messages call it
// (E0199).

#include <array>
#include <string>
#include <string_view>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// What the checker itself refuses.
inline constexpr std::string_view kStoringParts = "storing into several parts of a matrix at once";
inline constexpr std::string_view kStoringPlaces = "storing into several places of a list at once";
inline constexpr std::array kLaterInLanguage = {kStoringParts, kStoringPlaces};

// What a program has to wait for that calls a function of the tables with nothing behind it yet:
// "`camera`" of the row "camera{}", or what its help says.
[[nodiscard]] inline std::string later_feature(const NativeFunction& function) {
  if (!function.help.empty()) return std::string(function.help);
  return '`' + std::string(function.name.substr(0, function.name.find_first_of("[{("))) + '`';
}

}  // namespace armlet
