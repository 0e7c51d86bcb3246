#pragma once
// Smoothed pictures, in whole numbers: the same bits on every machine. Pixels of the border are
// continued outwards.

#include "armlet/image/image.hpp"

namespace armlet {

// Each pixel becomes the mean of the (2 radius + 1) x (2 radius + 1) pixels around it, rounded to
// the nearest grey level, halves upwards. The time does not depend on the radius.
//
// image   grey or RGB.
// radius  px, 0 to 100.
// throws  ArgumentError for a picture of depths or a radius out of range.
Image box_blurred(const Image& image, int radius);

// Each pixel becomes the mean of the pixels around it with the weights
// exp(-(dx^2 + dy^2) / (2 sigma^2)), cut off at ceil(3 sigma) px. Weights are multiples of 2^-16
// whose sum is 1; rows are rounded to 2^-8 grey levels before columns are summed.
//
// image   grey or RGB.
// sigma   standard deviation, px, 0 to 30; 0 changes nothing.
// throws  ArgumentError for a picture of depths or a sigma out of range.
Image gaussian_blurred(const Image& image, double sigma);

}  // namespace armlet
