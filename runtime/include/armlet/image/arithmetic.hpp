#pragma once
// Operations on single pixels: results are pictures of the same size, with documented rounding.

#include "armlet/image/image.hpp"

namespace armlet {

// The picture in shades of grey: (299 r + 587 g + 114 b + 500) / 1000, rounded down, which is
// 0.299 r + 0.587 g + 0.114 b to the nearest grey level. A grey picture stays as it is.
//
// throws  ArgumentError for a picture of depths or without pixels.
// source  ITU-R Recommendation BT.601-7, 2011, 2.5.1.
Image to_grey(const Image& image);

// 255 where a grey picture is brighter than `level`, else 0.
//
// level   grey levels, 0 to 255.
// throws  ArgumentError for another kind of picture or a level out of range.
Image threshold(const Image& grey, int level);

// |a - b| of every channel; of depths in metres.
//
// throws  ArgumentError with both sizes unless sizes and kinds are equal.
Image absolute_difference(const Image& a, const Image& b);

// min(a + b, 255) of every channel; of depths the sum.
//
// throws  as absolute_difference.
Image saturating_sum(const Image& a, const Image& b);

// min(factor * value, 255) of every channel, rounded to the nearest grey level, halves upwards; of
// depths the product.
//
// factor  0 to 1,000,000.
// throws  ArgumentError for a factor out of range.
Image scaled(const Image& image, double factor);

// The part with left <= x < right and top <= y < bottom, px.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  bool operator==(const PixelBox& other) const = default;
};

// The part of a picture that lies in the box.
//
// throws  ArgumentError with the box and the size unless it lies in the picture and holds a pixel.
Image cropped(const Image& image, const PixelBox& box);

}  // namespace armlet
