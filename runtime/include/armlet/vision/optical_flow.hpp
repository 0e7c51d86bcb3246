#pragma once

#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// window  px, odd: side of the square around a point that is compared, 5 to 51.
// levels  number of halvings of the pictures, 0 to 8, for large displacements.
// within  px: a point is lost if following it to the other picture and back ends farther than this
//         from its start.
struct FlowOptions {
  int window = 21;
  int levels = 3;
  double within = 0.5;
};

// points    positions in the second picture, px; of lost points the first position.
// way_back  px, distance from the start after following back; infinity if the point was lost
//           before.
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
