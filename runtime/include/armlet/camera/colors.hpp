#pragma once
// Colours by name, as used for the objects of a cell.

#include <optional>
#include <string_view>

#include "armlet/camera/texture.hpp"

namespace armlet {

// Linear light of a colour that color_code (world/looks.hpp) accepts; nothing for other words.
std::optional<LinearRgb> color_named(std::string_view text);

}  // namespace armlet
