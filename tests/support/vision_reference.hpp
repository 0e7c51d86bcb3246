#pragma once

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>

#include "armlet/image/files.hpp"

namespace armlet {

// Names of the reference pictures.
inline constexpr std::array<const char*, 6> kReferencePictures{
    "checkerboard", "lshape", "square_rot00", "square_rot17_noise10", "square_rot30", "star"};

// The bytes of a file of tests/reference/vision.
inline std::string vision_reference(const std::string& name) {
  std::ifstream file(std::string(ARMLET_REFERENCE_DIR) + "/vision/" + name, std::ios::binary);
  REQUIRE_MESSAGE(file, name);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline Image reference_picture(const std::string& name) {
  return read_image(vision_reference(name + ".pgm")).value();
}

}  // namespace armlet
