#include "armlet/camera/colors.hpp"

#include "armlet/world/looks.hpp"

namespace armlet {

std::optional<LinearRgb> color_named(std::string_view text) {
  const auto code = color_code(text);
  if (!code) return std::nullopt;
  return linear_rgb(static_cast<std::uint8_t>(*code >> 16U), static_cast<std::uint8_t>(*code >> 8U),
                    static_cast<std::uint8_t>(*code));
}

}  // namespace armlet
