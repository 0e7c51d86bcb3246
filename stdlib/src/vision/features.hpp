#pragma once
// What functions of corners share.

#include <string_view>

#include "armlet/image/image.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/correspondence.hpp"
#include "session/bind.hpp"

namespace armlet::bind {

// A grey picture that is not too large to be looked through; counts the work of that.
Answer<void> searchable(Vm& vm, const Image& image);

// The detector of that name; R0681 if there is none.
Answer<CornerMethod> corner_method(Vm& vm, std::string_view word, int parameter);

// R0682: which wanted points have no corner within so many pixels.
Failed fail_lost(Vm& vm, const Matches& matches, double within, int parameter);

// Points that match_points takes.
Answer<PlanePoints> few_enough(Vm& vm, PlanePoints points);

}  // namespace armlet::bind
