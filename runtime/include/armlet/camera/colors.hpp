#pragma once
// Colours by name, as objects of a cell have them.

#include <optional>
#include <string_view>

#include "armlet/camera/texture.hpp"

namespace armlet {

// Linear light of a colour that color_code (world/looks.hpp) knows; nothing for other words.
std::optional<LinearRgb> color_named(std::string_view text);

}  // namespace armlet
