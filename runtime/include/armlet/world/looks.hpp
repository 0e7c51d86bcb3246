// Colours of objects by name, and pictures on their surfaces.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace armlet {

// 0xrrggbb for a colour name of CSS, in upper or lower case, or "#rrggbb"; nothing for other words.
//
// source  W3C, CSS Color Module Level 4, 2022, section 6.1.
std::optional<std::uint32_t> color_code(std::string_view text);
bool is_color(std::string_view text);
// The name most like a mistyped one; nothing if none is similar.
std::optional<std::string_view> similar_color(std::string_view text);

// Why bytes are not a PNG or JPEG that can be shown (image/picture_size.hpp), as a sentence without
// a full stop; empty if they are.
std::string picture_fault(std::string_view bytes);

}  // namespace armlet
