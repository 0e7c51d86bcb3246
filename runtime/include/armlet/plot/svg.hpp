#pragma once

#include <span>
#include <string>

#include "armlet/plot/figure.hpp"

namespace armlet {

// Pictures as SVG, one below the other: axes with units and round values, a legend, colours that
// colour-blind readers can distinguish, on light and on dark pages; without scripts and external
// files. The same figures give the same text.
//
// Values that are not finite (or beyond 1e304) are left out, lines have a gap there, and a note
// gives their number. Thousands of points are merged into cells of two pixels; in space the colour
// shows the height.
std::string to_svg(std::span<const Figure> figures);

}  // namespace armlet
