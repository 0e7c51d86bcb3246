#include "armlet/image/check_kind.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

void check_pixels(std::string_view function, const Image& image) {
  if (image.is_empty())
    throw ArgumentError(
        fmt::format("`{}` got a picture of 0 x 0 pixels; "
                    "expected at least 1 x 1.",
                    function));
}

}  // namespace

void check_grey(std::string_view function, const Image& image) {
  check_pixels(function, image);
  if (image.kind() == PixelKind::kGrey) return;
  throw ArgumentError(
      fmt::format("`{}` takes a grey picture, not one of {}.", function,
                  image.kind() == PixelKind::kRgb ? "red, green and blue" : "depths"));
}

void check_8_bit(std::string_view function, const Image& image) {
  check_pixels(function, image);
  if (image.kind() != PixelKind::kDepth) return;
  throw ArgumentError(
      fmt::format("`{}` takes a grey or coloured picture, not one of depths.", function));
}

}  // namespace armlet
