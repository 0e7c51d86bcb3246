#pragma once

#include <string>

#include "armlet/plot/figure.hpp"

namespace armlet {

// The picture of a figure in a frame, with its title above and its note below; at most `columns`
// and `rows` characters, which are twice as high as wide.
std::string picture_text(const Figure& figure, int columns, int rows, bool color);

}  // namespace armlet
