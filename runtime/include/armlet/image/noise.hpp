#pragma once

#include "armlet/core/random.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// Adds Gaussian noise to every channel of every pixel, rounded to the nearest grey level and cut
// off at 0 and 255. Four numbers are drawn from 64 random bits by the inverse of the distribution
// in steps of 2^-16, so that none is farther from 0 than 4.33 sigma. The same state of the
// generator gives the same noise on every machine.
//
// image   grey or RGB.
// sigma   standard deviation, grey levels, 0 to 255.
// throws  ArgumentError for a picture of depths or a sigma out of range.
void add_noise(Image& image, double sigma, Random& random);

}  // namespace armlet
