#pragma once

#include <cstdint>
#include <random>

#include "armlet/image/image.hpp"

namespace armlet {

// A picture in which every value is random.
inline Image random_image(std::mt19937_64& generator, int width, int height, PixelKind kind) {
  Image image(width, height, kind);
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < width * image.channels(); ++i) {
      const std::uint64_t bits = generator();
      if (kind == PixelKind::kDepth) {
        image.depth_row(y)[i] = static_cast<float>(bits >> 40) * 0x1p-20F;
      } else {
        image.row(y)[i] = static_cast<std::uint8_t>(bits >> 32);
      }
    }
  }
  return image;
}

}  // namespace armlet
