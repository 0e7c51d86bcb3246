#pragma once

#include <span>
#include <string>

#include "armlet/plot/figure.hpp"

namespace armlet {

// Pictures as SVG, one below the other: axes with units and round values, a legend, colours that
// the colour-blind tell apart, on light and on dark pages; no scripts, nothing to load. The same
// figures give the same text.
//
// Values that are not finite (or beyond 1e304) are left out, lines have a gap there, and a note
// says how many. Thousands of points become cells of two pixels; in space the colour shows the
// height.
std::string to_svg(std::span<const Figure> figures);

}  // namespace armlet
