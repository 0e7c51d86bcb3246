#pragma once
// Corners by FAST: at least nine connected pixels of a circle around a corner are all brighter or
// all darker than it.

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// Corners at whole pixels from the strongest to the weakest, n x 2, by OpenCV (opencv.hpp); of
// neighbours the strongest one.
//
// grey       one channel of 8 bits.
// threshold  grey levels, 1 to 255: least difference of the pixels of the circle.
// throws     ArgumentError for another kind of picture, more than 4,194,304 pixels, a threshold out
//            of range, and where there is no OpenCV.
// source     E. Rosten, T. Drummond, Machine learning for high-speed corner detection, ECCV 2006.
PlanePoints fast_corners(const Image& grey, int threshold = 20);

}  // namespace armlet
