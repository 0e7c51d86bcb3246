#pragma once
// Corners by SUSAN: a pixel is a corner if few pixels around it are about as bright as it is.

#include <vector>

#include "armlet/chain/instruction_set.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// threshold  grey levels, 1 to 255: pixels whose brightness differs by much less count as similar.
// set        the widest vector registers that are used; the corners do not depend on it.
struct SusanOptions {
  int threshold = 20;
  InstructionSet set = best_instruction_set();
};

// A corner at whole pixels.
//
// x, y        px, x to the right, y down.
// response    1850 - n, 1 to 1750: the larger, the sharper. n is the area of the pixels that are
//             about as bright as the corner, in hundredths of a pixel.
// sum_x, sum_y  the sums of their offsets, so that (sum_x, sum_y) / n is the mean offset in px; it
//             points into the corner.
// brightness  of the corner's pixel, grey levels.
struct SusanCorner {
  int x = 0;
  int y = 0;
  int response = 0;
  int sum_x = 0;
  int sum_y = 0;
  int brightness = 0;

  bool operator==(const SusanCorner& other) const = default;
};

// The corners of a picture in the order of rows from the top, each row from the left.
//
// With the mask of 37 pixels, similarity c(d) = 100 exp(-(d / threshold)^6), truncated, and n = sum
// of c over the mask: a corner has n < 1850 = 100 * 37 / 2, a centroid farther than sqrt(1/2) px
// from it, three similar pixels towards the centroid, and the largest response of 7 x 7 pixels (of
// several equal ones the first). Pixels nearer than 5 px to the border are not corners.
//
// grey    one channel of 8 bits.
// throws  ArgumentError for another kind of picture, a threshold out of range, or a set that this
//         processor does not have.
// source  S. M. Smith and J. M. Brady, SUSAN - a new approach to low level image processing,
//         International Journal of Computer Vision 23(1), 1997, eq. 4, 24, 25 and section 4.
std::vector<SusanCorner> susan_corners(const Image& grey, const SusanOptions& options = {});

}  // namespace armlet
