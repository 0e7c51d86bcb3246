#pragma once

#include <string_view>

#include "armlet/image/image.hpp"

namespace armlet {

// Throws ArgumentError "`susan_corners` takes a grey picture, not one of red, green and blue." or a
// message that the picture has no pixels.
void check_grey(std::string_view function, const Image& image);

// Throws ArgumentError, with such a message, unless the picture is grey or coloured with 8 bits.
void check_8_bit(std::string_view function, const Image& image);

}  // namespace armlet
