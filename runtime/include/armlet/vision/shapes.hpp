#pragma once
// Regions of pictures and their outlines, by OpenCV (opencv.hpp). All throw ArgumentError for
// another kind of picture, more than 4,194,304 pixels, an option out of range
// (image/parameters.hpp) and where there is no OpenCV.

#include <cstdint>
#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// 255 where a pixel is brighter than the mean of its neighbourhood minus `offset`, else 0: for
// unevenly lit pictures.
//
// grey      one channel of 8 bits.
// radius    px; the neighbourhood is a square with 2 radius + 1 pixels on each side.
// gaussian  whether the mean has Gaussian weights.
Image adaptive_threshold(const Image& grey, int radius = 10, double offset = 5.0,
                         bool gaussian = false);

// Every pixel becomes the darkest (kErode) or brightest (kDilate) one around it; kOpen erodes and
// then dilates, which removes small bright regions; kClose does the opposite.
//
// image   8 bits; channels are processed separately.
// radius  px, of a square with 2 radius + 1 pixels on each side, or of a disc.
// source  J. Serra, Image analysis and mathematical morphology, 1982.
enum class Morphology : std::uint8_t { kErode, kDilate, kOpen, kClose };
Image changed_by(Morphology operation, const Image& image, int radius = 1, bool disc = false);

// The outlines of regions that are not black, ordered by their first pixels from the top: the
// border pixels of the region in sequence.
//
// grey      one channel of 8 bits.
// holes     whether borders of holes are returned too.
// min_area  px^2 within the outline; smaller ones are left out. At most 10,000 are returned.
// source    S. Suzuki, K. Abe, Topological structural analysis of digitized binary images by border
//           following, Computer Vision, Graphics, and Image Processing 30, 1985.
std::vector<PlanePoints> find_contours(const Image& grey, bool holes = false,
                                       double min_area = 0.0);

// The corners of a polygon that differs from a closed outline by at most `tolerance`.
//
// contour    n x 2, 1 <= n <= 100,000, px.
// tolerance  px, >= 0.
// source     D. Douglas, T. Peucker, Algorithms for the reduction of the number of points required
//            to represent a digitized line, Cartographica 10, 1973.
PlanePoints polygon_of(const PlanePoints& contour, double tolerance = 2.0);

}  // namespace armlet
