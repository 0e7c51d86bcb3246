#pragma once
// Colours by name, as objects of a cell have them.

#include <optional>
#include <string_view>

#include "armlet/camera/texture.hpp"

namespace armlet {

// Linear light of a colour of CSS by its name, in whatever case, or of "#rrggbb"; nothing for other
// words (those that is_color of world/looks.hpp refuses).
//
// source  W3C, CSS Color Module Level 4, 2022, section 6.1.
std::optional<LinearRgb> color_named(std::string_view text);

}  // namespace armlet
