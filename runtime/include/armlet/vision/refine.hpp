#pragma once
// Corners to fractions of a pixel.

#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// window      px; gradients are used from a square with 2 window + 1 pixels on each side. It should
//             contain one corner only.
// iterations  largest number of steps.
// precision   px; the search ends after a shorter step.
struct RefineOptions {
  int window = 5;
  int iterations = 40;
  double precision = 0.001;
};

// How a search ended: with a short step; after all iterations; because the window is flat or
// contains a straight edge only; or because it left the window, in which case the start is
// returned.
enum class RefineEnd { kConverged, kIterations, kNoCorner, kLeft };

// x, y  px.
struct RefinedCorner {
  double x = 0.0;
  double y = 0.0;
  RefineEnd end = RefineEnd::kConverged;
};

// Refined corners near given starts. The gradient at any point of an edge is perpendicular to the
// line from the corner to that point, so the corner c minimises the sum of w (g . (p - c))^2 over
// the points p of the window, with Gaussian weights w around the last c. Brightness between pixels
// is bilinear.
//
// grey    one channel of 8 bits.
// starts  n x 2, px, within the picture.
// throws  ArgumentError for another kind of picture, an option out of range, or a start outside.
// source  W. Foerstner and E. Guelch, A fast operator for detection and precise location of
//         distinct points, corners and centres of circular features, ISPRS 1987, eq. 4 to 8.
std::vector<RefinedCorner> refine_corners(const Image& grey, const PlanePoints& starts,
                                          const RefineOptions& options = {});

}  // namespace armlet
