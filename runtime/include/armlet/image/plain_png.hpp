#pragma once

#include <string>

#include "armlet/image/image.hpp"

namespace armlet {

// The bytes of a PNG file without any library: the same on every machine and in a page. Runs of
// equal bytes are short in it; of what is not drawn but photographed it is about as long as the
// pixels.
//
// image   grey or RGB.
// throws  ArgumentError for a picture of depths or without pixels.
// source  W3C, Portable Network Graphics, 2003; RFC 1950 and RFC 1951, 1996.
[[nodiscard]] std::string plain_png(const Image& image);

}  // namespace armlet
