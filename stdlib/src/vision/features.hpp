#pragma once
// What functions of corners share.

#include <string_view>
#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/correspondence.hpp"
#include "session/bind.hpp"

namespace armlet::bind {

// R0681 unless a picture is grey and not too large to be looked through.
Answer<void> searchable(Vm& vm, const Image& image);

// The detector of that name; R0681 if there is none.
Answer<CornerMethod> corner_method(Vm& vm, std::string_view word, int parameter);

// R0682: these wanted points have no corner within so many pixels.
//
// distance  of each wanted point from the nearest corner, px.
Failed fail_lost(Vm& vm, const std::vector<int>& lost, const std::vector<double>& distance,
                 double within, int parameter);

// Points that match_points takes.
Answer<PlanePoints> few_enough(Vm& vm, PlanePoints points);

}  // namespace armlet::bind
