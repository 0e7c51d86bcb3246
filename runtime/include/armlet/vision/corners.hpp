#pragma once
// Corners by one of the detectors, refined, and those near given positions.

#include <cstdint>

#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

enum class CornerMethod : std::uint8_t { kSusan, kHarris, kFast };

// threshold    of SUSAN and FAST, grey levels (susan.hpp, fast.hpp).
// quality, distance, sensitivity  of Harris (harris.hpp).
// max          largest number of corners, the strongest ones; 0: all.
// refine       to fractions of a pixel (refine.hpp); a corner that cannot be refined keeps whole
//              pixels.
struct CornerOptions {
  CornerMethod method = CornerMethod::kSusan;
  int threshold = 20;
  double quality = 0.01;
  double distance = 10.0;
  double sensitivity = 0.04;
  int max = 0;
  bool refine = true;
};

// The corners of a picture, the strongest first, equally strong ones in the order of rows, n x 2.
//
// grey    one channel of 8 bits.
// throws  ArgumentError for another kind of picture or an option out of range; kFast also where
//         there is no OpenCV.
PlanePoints find_corners(const Image& grey, const CornerOptions& options = {});

// The corners near some positions. Only a part of the picture is searched: the bounding box of the
// positions, enlarged by `within` pixels on every side. Responses of Harris are compared within it.
//
// places  k x 2, k >= 1, px; they may lie outside of the picture.
// throws  as find_corners, and for no positions or numbers that are not finite.
PlanePoints find_corners_around(const Image& grey, const PlanePoints& places, double within,
                                const CornerOptions& options = {});

}  // namespace armlet
