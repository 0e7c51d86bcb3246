#pragma once

#include <string>

#include "armlet/plot/figure.hpp"

namespace armlet {

// A figure as text for a terminal: braille characters of 2 x 4 dots inside axes with their values.
//
// columns, rows  of the field of dots, in characters; at least 8 and 4. A picture keeps its
//                proportions within the columns and twice the rows.
// color          whether each series has a colour of the terminal; a picture then has two pixels in
//                each character, in the 256 colours of xterm, instead of dots where it is bright.
std::string to_braille(const Figure& figure, int columns = 72, int rows = 18, bool color = false);

}  // namespace armlet
