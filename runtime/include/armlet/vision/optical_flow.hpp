#pragma once

#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// window  px, odd: side of the square around a point that is compared, 5 to 51.
// levels  how often the pictures are halved, 0 to 8, for points that move far.
// within  px: a point that is farther than this from where it was after it was followed to the
//         other picture and back is lost.
struct FlowOptions {
  int window = 21;
  int levels = 3;
  double within = 0.5;
};

// points    where the points of the first picture are in the second, px; lost ones where they were.
// way_back  px, how far each is from its start after it was followed back; infinity if it was lost
//           on the way.
// lost      rows of the points that were lost.
struct FollowedPoints {
  PlanePoints points;
  std::vector<double> way_back;
  std::vector<int> lost;
};

// Follows points from one picture to the next by the brightness around them, by OpenCV
// (opencv.hpp).
//
// from, to  one channel of 8 bits, of one size.
// points    1 to 1000 x 2, px, in the first picture.
// throws    ArgumentError for other pictures and points, more than 4,194,304 pixels, an option out
//           of range, and where there is no OpenCV.
// source    B. Lucas, T. Kanade 1981; J.-Y. Bouguet 2000 (pyramids); Z. Kalal, K. Mikolajczyk,
//           J. Matas, Forward-backward error, ICPR 2010.
FollowedPoints follow_points(const Image& from, const Image& to, const PlanePoints& points,
                             const FlowOptions& options = {});

}  // namespace armlet
