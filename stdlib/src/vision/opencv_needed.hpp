#pragma once
// Helpers shared by functions of pictures that use OpenCV.

#include <string_view>

#include "values/bind.hpp"
#include "values/world/pictures.hpp"

namespace armlet::bind {

// R0691 unless OpenCV is available: "`edges` needs OpenCV, which is not there".
Answer<void> opencv_for(Vm& vm, std::string_view function);

// R0681 unless the picture is grey, and small enough for a function of OpenCV to end soon.
Answer<void> grey_for_opencv(Vm& vm, const Image& image, CallPart part = CallPart::first());

// Runs f() for `function` after charging this number of operations; its refusals are R0681.
template <class F>
auto with_opencv(Vm& vm, std::string_view function, std::uint64_t operations, F f)
    -> Answer<decltype(f())> {
  if (!opencv_for(vm, function)) return Failed{};
  return with_pictures(vm, operations, f);
}

}  // namespace armlet::bind
