#include "armlet/image/arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"

namespace armlet {
namespace {

const char* name_of(PixelKind kind) {
  return kind == PixelKind::kGrey ? "grey" : kind == PixelKind::kRgb ? "RGB" : "depth";
}

void check_alike(const char* function, const Image& a, const Image& b) {
  if (a.width() == b.width() && a.height() == b.height() && a.kind() == b.kind()) return;
  throw ArgumentError(
      fmt::format("`{}` got pictures of {} x {} ({}) and {} x {} ({}); expected "
                  "the same size and kind.",
                  function, a.width(), a.height(), name_of(a.kind()), b.width(), b.height(),
                  name_of(b.kind())));
}

Image blank_like(const Image& image) {
  return image.is_empty() ? Image() : Image(image.width(), image.height(), image.kind());
}

// Applies a function to all values of two pictures of equal size and kind.
template <class OfBytes, class OfDepths>
Image combined(const Image& a, const Image& b, OfBytes of_bytes, OfDepths of_depths) {
  Image result = blank_like(a);
  if (a.is_empty()) return result;
  std::transform(a.bytes().begin(), a.bytes().end(), b.bytes().begin(), result.row(0), of_bytes);
  std::transform(a.depths().begin(), a.depths().end(), b.depths().begin(), result.depth_row(0),
                 of_depths);
  return result;
}

}  // namespace

Image to_grey(const Image& image) {
  check_8_bit("gray", image);
  if (image.kind() == PixelKind::kGrey) return image;
  Image grey(image.width(), image.height(), PixelKind::kGrey);
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* from = image.row(y);
    std::uint8_t* to = grey.row(y);
    for (int x = 0; x < image.width(); ++x, from += 3)
      to[x] =
          static_cast<std::uint8_t>((299 * from[0] + 587 * from[1] + 114 * from[2] + 500) / 1000);
  }
  return grey;
}

Image threshold(const Image& grey, int level) {
  check_grey("threshold", grey);
  check_picture_parameter("threshold", "level", level);
  Image result = blank_like(grey);
  std::transform(
      grey.bytes().begin(), grey.bytes().end(), result.row(0),
      [level](std::uint8_t value) { return static_cast<std::uint8_t>(value > level ? 255 : 0); });
  return result;
}

Image absolute_difference(const Image& a, const Image& b) {
  check_alike("absolute_difference", a, b);
  return combined(
      a, b,
      [](std::uint8_t p, std::uint8_t q) {
        return static_cast<std::uint8_t>(p > q ? p - q : q - p);
      },
      [](float p, float q) { return std::abs(p - q); });
}

Image saturating_sum(const Image& a, const Image& b) {
  check_alike("saturating_sum", a, b);
  return combined(
      a, b,
      [](std::uint8_t p, std::uint8_t q) {
        return static_cast<std::uint8_t>(std::min(int{p} + int{q}, 255));
      },
      [](float p, float q) { return p + q; });
}

Image scaled(const Image& image, double factor) {
  check_picture_parameter("scale", "factor", factor);
  Image result = blank_like(image);
  if (image.is_empty()) return result;
  std::array<std::uint8_t, 256> table{};
  for (int value = 0; value < 256; ++value)
    table[static_cast<std::size_t>(value)] =
        static_cast<std::uint8_t>(std::min(std::floor(value * factor + 0.5), 255.0));
  std::transform(image.bytes().begin(), image.bytes().end(), result.row(0),
                 [&table](std::uint8_t value) { return table[value]; });
  std::transform(image.depths().begin(), image.depths().end(), result.depth_row(0),
                 [factor](float value) { return static_cast<float>(value * factor); });
  return result;
}

Image cropped(const Image& image, const PixelBox& box) {
  if (box.left < 0 || box.top < 0 || box.left >= box.right || box.top >= box.bottom ||
      box.right > image.width() || box.bottom > image.height()) {
    throw ArgumentError(fmt::format(
        "The part {} <= x < {}, {} <= y < {} is empty or leaves the picture of {} x {} pixels.",
        box.left, box.right, box.top, box.bottom, image.width(), image.height()));
  }
  Image part(box.right - box.left, box.bottom - box.top, image.kind());
  const std::ptrdiff_t skipped = std::ptrdiff_t{box.left} * image.channels();
  const std::ptrdiff_t count = std::ptrdiff_t{part.width()} * image.channels();
  for (int y = 0; y < part.height(); ++y) {
    if (image.kind() == PixelKind::kDepth) {
      std::copy_n(image.depth_row(box.top + y) + skipped, count, part.depth_row(y));
    } else {
      std::copy_n(image.row(box.top + y) + skipped, count, part.row(y));
    }
  }
  return part;
}

}  // namespace armlet
