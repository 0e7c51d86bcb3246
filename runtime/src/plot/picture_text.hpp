#pragma once

#include <string>

#include "armlet/plot/figure.hpp"

namespace armlet {

// The picture of a figure in a frame, below its title and above its note; `columns` and `rows` at
// most, in characters that are twice as high as wide.
std::string picture_text(const Figure& figure, int columns, int rows, bool color);

}  // namespace armlet
