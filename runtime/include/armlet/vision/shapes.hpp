#pragma once
// Regions of pictures and their outlines, by OpenCV (opencv.hpp). All throw ArgumentError for
// another kind of picture, more than 4,194,304 pixels, an option out of range
// (image/parameters.hpp) and where there is no OpenCV.

#include <cstdint>
#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// 255 where a pixel is brighter than the mean of its neighbourhood less `offset`, else 0: for
// pictures that are lit unevenly.
//
// grey      one channel of 8 bits.
// radius    px; the neighbourhood is a square with 2 radius + 1 pixels on each side.
// gaussian  whether the mean is weighted by a Gaussian bell.
Image adaptive_threshold(const Image& grey, int radius = 10, double offset = 5.0,
                         bool gaussian = false);

// Every pixel becomes the darkest (kErode) or brightest (kDilate) one around it; kOpen erodes and
// then dilates, so that what is small and bright is gone; kClose does it the other way round.
//
// image   8 bits; each channel for itself.
// radius  px, of a square with 2 radius + 1 pixels on each side, or of a disc.
// source  J. Serra, Image analysis and mathematical morphology, 1982.
enum class Morphology : std::uint8_t { kErode, kDilate, kOpen, kClose };
Image changed_by(Morphology operation, const Image& image, int radius = 1, bool disc = false);

// The outlines of regions that are not black, in the order of their first pixels from the top: the
// pixels of the region on its border, one after the other.
//
// grey      one channel of 8 bits.
// holes     whether borders of holes are given too.
// min_area  px^2 within the outline; smaller ones are left out. At most 10,000 are given.
// source    S. Suzuki, K. Abe, Topological structural analysis of digitized binary images by border
//           following, Computer Vision, Graphics, and Image Processing 30, 1985.
std::vector<PlanePoints> find_contours(const Image& grey, bool holes = false,
                                       double min_area = 0.0);

// The corners of a polygon that is nowhere farther from a closed outline than `tolerance`.
//
// contour    n x 2, 1 <= n <= 100,000, px.
// tolerance  px, >= 0.
// source     D. Douglas, T. Peucker, Algorithms for the reduction of the number of points required
//            to represent a digitized line, Cartographica 10, 1973.
PlanePoints polygon_of(const PlanePoints& contour, double tolerance = 2.0);

}  // namespace armlet
