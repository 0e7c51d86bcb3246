#pragma once
// Helpers shared by functions of corners.

#include <string_view>
#include <utility>
#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/interpreter/failure.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/correspondence.hpp"
#include "values/bind.hpp"
#include "values/world/cameras.hpp"

namespace armlet::bind {

// R0681 unless a picture is grey and small enough to be searched.
Answer<void> searchable(Vm& vm, const Image& image);

// The detector of that name; R0681 if there is none.
Answer<CornerMethod> corner_method(Vm& vm, std::string_view word, CallPart part);

// The positions found for wanted points: one row for each; the rows of lost points have no meaning.
struct FoundCorners : FailureDetail {
  FoundCorners(PlanePoints found, std::vector<int> missing, double px)
      : points(std::move(found)), lost(std::move(missing)), within(px) {}

  PlanePoints points;
  std::vector<int> lost;
  double within;  // px, of each from where it was wanted
};

// R0682: these wanted points have no corner within the search radius. The failure carries `found`.
//
// distance  of each wanted point from the nearest corner, px.
Failed fail_lost(Vm& vm, FoundCorners found, const std::vector<double>& distance, CallPart part);

// Fails if there are more points than match_points accepts.
Answer<PlanePoints> few_enough(Vm& vm, PlanePoints points);

// R0683: "these points do not determine an answer: ...".
Failed undetermined(Vm& vm, const Error& error);

// Normalised coordinates of pixels, without distortion: x = X/Z, y = Y/Z.
Answer<PlanePoints> seen_by(Vm& vm, const CameraRef& c, const PlanePoints& pixels);

// The PlanarPose of points in a plane.
Answer<RecordObj*> flat_pose(Vm& vm, const CameraRef& c, const PlanePoints& pixels,
                             const Points& points);

}  // namespace armlet::bind
