#include "armlet/image/image.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"

namespace armlet {

Image::Image(int width, int height, PixelKind kind) : width_(width), height_(height), kind_(kind) {
  if (width < 1 || height < 1 || width > kMostSide || height > kMostSide) {
    throw ArgumentError(fmt::format("A picture has sides of 1 to {} pixels, not {} x {}.",
                                    kMostSide, width, height));
  }
  const std::size_t values =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height * channels());
  if (kind == PixelKind::kDepth) {
    depths_.resize(values);
  } else {
    bytes_.resize(values);
  }
}

}  // namespace armlet
