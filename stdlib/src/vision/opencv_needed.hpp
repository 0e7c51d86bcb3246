#pragma once
// What functions of pictures by OpenCV share.

#include <string_view>

#include "session/bind.hpp"
#include "vision/pictures.hpp"

namespace armlet::bind {

// R0691 unless OpenCV is there: "`edges` needs OpenCV, which is not there".
Answer<void> opencv_for(Vm& vm, std::string_view function);

// R0681 unless the picture is grey, and so small that a function of OpenCV ends soon.
Answer<void> grey_for_opencv(Vm& vm, const Image& image, int parameter = 0);

// f() of `function`, after so many operations were counted; what it refuses is R0681.
template <class F>
auto with_opencv(Vm& vm, std::string_view function, std::uint64_t operations, F f)
    -> Answer<decltype(f())> {
  if (!opencv_for(vm, function)) return Failed{};
  return with_pictures(vm, operations, f);
}

}  // namespace armlet::bind
