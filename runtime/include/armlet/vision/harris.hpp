#pragma once
// Corners by Harris: positions where the brightness changes in two directions.

#include <vector>

#include "armlet/image/image.hpp"

namespace armlet {

// quality      corners whose response is not above this share of the strongest one are left out.
// distance     px; a corner nearer than this to a stronger one is left out. 0: no corner is.
// sensitivity  k, 0 to 0.25; edges have negative responses from about 0.04 on.
// max          largest number of corners; 0: all.
struct HarrisOptions {
  double quality = 0.01;
  double distance = 10.0;
  double sensitivity = 0.04;
  int max = 0;
};

// A corner at whole pixels, px, x to the right, y down.
struct HarrisCorner {
  int x = 0;
  int y = 0;
  double response = 0.0;
};

// The corners of a picture from the strongest to the weakest, equal ones in the order of rows.
//
// M = sum of [gx gx, gx gy; gx gy, gy gy] over 3 x 3 pixels, with gradients by 3 x 3 Sobel masks
// divided by 3060 (1 for a step from black to white), and the response det(M) - k trace(M)^2. A
// corner has a positive response that is at least that of its 8 neighbours. Beyond the border the
// picture is mirrored about its border pixels, which are never corners. Sums are integers, so the
// corners are the same on every machine.
//
// grey    one channel of 8 bits.
// throws  ArgumentError for another kind of picture or an option out of range.
// source  C. Harris and M. Stephens, A combined corner and edge detector, Alvey Vision Conference
//         1988, section 3; distances as J. Shi and C. Tomasi, Good features to track, 1994.
std::vector<HarrisCorner> harris_corners(const Image& grey, const HarrisOptions& options = {});

}  // namespace armlet
