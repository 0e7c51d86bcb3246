#pragma once
// Connected regions of pictures with their moments.

#include <array>
#include <cstdint>
#include <vector>

#include "armlet/image/arithmetic.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// Whether pixels of one region are connected along sides only (4 neighbours) or also at corners
// (8).
enum class Touching : std::uint8_t { kSides, kCorners };

// min_area  px; smaller regions are left out.
struct BlobOptions {
  int min_area = 20;
  Touching touching = Touching::kCorners;
};

// A connected region.
//
// x, y    px, its centre of area.
// area    px.
// angle   rad, of its long axis, from the x axis towards the y axis (clockwise in the picture), in
//         (-pi/2, pi/2]; 0 for regions without a long axis.
// width, height  px, sides of the rectangle with the same second moments, along the long axis and
//                across it; for a rectangle of whole pixels, its own sides.
// color   mean of red, green and blue, grey levels; of a grey picture three times the same.
// box     the bounding box along the axes of the picture, px.
struct Blob {
  double x = 0.0;
  double y = 0.0;
  int area = 0;
  double angle = 0.0;
  double width = 0.0;
  double height = 0.0;
  std::array<double, 3> color{};
  PixelBox box;
};

// The connected regions of the pixels of `mask` that are not 0, ordered by their first pixels in
// rows from the top. The time grows with the number of pixels, the memory with the width and the
// number of returned regions.
//
// mask     grey.
// picture  grey or RGB, of the same size; `color` is its mean over the region.
// throws   ArgumentError for another kind of picture, sizes that differ, or an option out of range.
// source   A. Rosenfeld and J. Pfaltz, Sequential operations in digital picture processing, Journal
//          of the ACM 13(4), 1966; moments as M.-K. Hu, IRE Trans. Information Theory 8(2), 1962.
std::vector<Blob> find_blobs(const Image& mask, const Image& picture,
                             const BlobOptions& options = {});

// 255 where red, green and blue all differ from the colour by at most the tolerance, else 0. In a
// grey picture all three are equal.
//
// tolerance  grey levels, 0 to 255.
// throws     ArgumentError for a picture of depths or a tolerance out of range.
Image color_mask(const Image& picture, std::array<std::uint8_t, 3> color, int tolerance);

}  // namespace armlet
