#pragma once

#include "armlet/image/image.hpp"

namespace armlet {

// The position where a template fits best.
//
// x, y   px, of the centre of the template in the picture, to fractions of a pixel.
// score  correlation of the deviations from the means, -1 to 1; 1 where both are equal except for
//        brightness and contrast.
struct TemplateMatch {
  double x = 0.0;
  double y = 0.0;
  double score = 0.0;
};

// The part of a picture that is most similar to a template, by OpenCV (opencv.hpp): the maximum of
// the normalised correlation at whole pixels, refined by a parabola through its neighbours.
//
// image, part  8 bits, of one kind; the template is not larger than the picture.
// throws  ArgumentError for other kinds and sizes, a template of one brightness, more than
//         4,194,304 pixels, and where there is no OpenCV.
// source  J. P. Lewis, Fast normalized cross-correlation, Vision Interface 1995.
TemplateMatch match_template(const Image& image, const Image& part);

}  // namespace armlet
