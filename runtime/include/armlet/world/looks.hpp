// What objects look like: colours by name, pictures on their surfaces.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace armlet {

// 0xrrggbb of a name of CSS, in whatever case, or of "#rrggbb"; nothing for other words.
//
// source  W3C, CSS Color Module Level 4, 2022, section 6.1.
std::optional<std::uint32_t> color_code(std::string_view text);
bool is_color(std::string_view text);
// The name most like a mistyped one; nothing if none is similar.
std::optional<std::string_view> similar_color(std::string_view text);

// Why bytes are no PNG or JPEG that can be shown (image/picture_size.hpp), as a sentence without an
// end; empty if they are one.
std::string picture_fault(std::string_view bytes);

}  // namespace armlet
