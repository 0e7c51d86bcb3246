#pragma once
// Texts in pictures, in DejaVu Sans of one size.

#include <cstdint>
#include <string>
#include <string_view>

#include "armlet/image/image.hpp"

namespace armlet::cli {

inline constexpr std::uint8_t kInk = 40;  // the grey of letters on white paper
inline constexpr int kLetterHeight = 22;  // pixels from the top of the highest letter to the lowest

// The width of a text in UTF-8, pixels. Characters outside Latin-1 are drawn as question marks.
[[nodiscard]] int width_of(std::string_view text);

// The longest beginning of a text that is not wider, with "..." if a part is left out.
[[nodiscard]] std::string fitted(std::string_view text, int width);

// grey  of the letters, 0 to 255. The text is cut off at the border of the picture.
void write(Image& image, int left, int top, std::string_view text, std::uint8_t grey);

}  // namespace armlet::cli
