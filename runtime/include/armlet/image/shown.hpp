#pragma once
// Pictures made ready for people to look at.

#include "armlet/image/image.hpp"

namespace armlet {

// The least and the greatest depth of a picture of depths, m; those that are not finite or not above
// zero, where nothing is seen, do not count. 0 and 0: there is none.
//
// throws  ArgumentError for another kind of picture.
struct DepthRange {
  float nearest = 0.0F;
  float farthest = 0.0F;
};
DepthRange depth_range(const Image& depths);

// Depths as grey levels: 255 for the nearest, 30 for the farthest, 0 where nothing is seen. Depths
// that differ by less than 0.1 % are nearly white: what rounding makes of a plane is not shown.
//
// throws  as depth_range.
Image grey_of_depths(const Image& depths);

// The picture in another size. Each pixel is the mean of the pixels that it covers, rounded to the
// nearest grey level, halves upwards; where it covers a part of one, it is that one.
//
// image          grey or RGB.
// width, height  1 to Image::kMostSide.
// throws         ArgumentError for a picture of depths or without pixels, or a side out of range.
Image resized(const Image& image, int width, int height);

}  // namespace armlet
