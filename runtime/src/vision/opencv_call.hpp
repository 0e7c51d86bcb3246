// Calls of OpenCV through its interface.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/image/image.hpp"
#include "vision/opencv_door.hpp"

namespace armlet {

// The results of a call.
struct OpencvResult {
  std::vector<double> numbers;
  Image picture;
  std::string refusal;
};

// Largest number of pixels of a picture, so that a call ends in about half a second.
inline constexpr std::int64_t kMostDoorPixels = 4'194'304;

// throws  ArgumentError for a picture that has more than `most` pixels, or is not of 8 bits; grey:
//         one that is not grey.
void check_door_picture(std::string_view function, const Image& image, bool grey,
                        std::int64_t most = kMostDoorPixels);

// A grey or colour picture in the form of the interface.
[[nodiscard]] DoorPicture door_picture(const Image& image);

// Calls a function of the interface.
//
// throws  ArgumentError with the reason if OpenCV refuses, or is not installed; std::bad_alloc.
OpencvResult call_opencv(DoorFunction OpencvDoor::*function, const DoorInput& input,
                         std::initializer_list<double> options = {});

}  // namespace armlet
