#include "armlet/image/shown.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"

namespace armlet {
namespace {

bool is_seen(float depth) { return std::isfinite(depth) && depth > 0.0F; }

// The first pixel of cell i of `count` in a row of `size` pixels.
int begin_of(int i, int size, int count) {
  return static_cast<int>(std::int64_t{i} * size / count);
}

}  // namespace

DepthRange depth_range(const Image& depths) {
  if (depths.kind() != PixelKind::kDepth)
    throw ArgumentError("`depth_range` takes a picture of depths.");
  DepthRange range;
  for (const float depth : depths.depths()) {
    if (!is_seen(depth)) continue;
    range.nearest = range.nearest == 0.0F ? depth : std::min(range.nearest, depth);
    range.farthest = std::max(range.farthest, depth);
  }
  return range;
}

Image grey_of_depths(const Image& depths) {
  const auto [nearest, farthest] = depth_range(depths);
  if (depths.is_empty()) return {};
  constexpr double kDarkest = 30.0, kLightest = 255.0, kLeast = 1e-3;
  const double range = std::max(double{farthest} - double{nearest}, kLeast * double{nearest});
  Image grey(depths.width(), depths.height(), PixelKind::kGrey);
  for (int y = 0; y < grey.height(); ++y) {
    const float* from = depths.depth_row(y);
    std::uint8_t* to = grey.row(y);
    for (int x = 0; x < grey.width(); ++x) {
      if (!is_seen(from[x])) continue;
      const double share = range > 0.0 ? (double{from[x]} - double{nearest}) / range : 0.0;
      to[x] = static_cast<std::uint8_t>(kLightest - (kLightest - kDarkest) * share + 0.5);
    }
  }
  return grey;
}

Image resized(const Image& image, int width, int height) {
  check_8_bit("resized", image);
  Image out(width, height, image.kind());
  const int channels = image.channels();
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(width * channels));
  for (int y = 0; y < height; ++y) {
    const int top = begin_of(y, image.height(), height);
    const int bottom = std::max(top + 1, begin_of(y + 1, image.height(), height));
    std::fill(sums.begin(), sums.end(), 0U);
    checkpoint(std::uint64_t(image.width()) * std::uint64_t(channels * (bottom - top)));
    for (int row = top; row < bottom; ++row) {
      const std::uint8_t* from = image.row(row);
      for (int x = 0; x < width; ++x) {
        const int left = begin_of(x, image.width(), width);
        const int right = std::max(left + 1, begin_of(x + 1, image.width(), width));
        for (int k = left * channels; k < right * channels; ++k)
          sums[static_cast<std::size_t>(x * channels + k % channels)] += from[k];
      }
    }
    std::uint8_t* to = out.row(y);
    for (int x = 0; x < width; ++x) {
      const int left = begin_of(x, image.width(), width);
      const int right = std::max(left + 1, begin_of(x + 1, image.width(), width));
      const auto count = static_cast<std::uint32_t>((bottom - top) * (right - left));
      for (int c = 0; c < channels; ++c) {
        const std::uint32_t sum = sums[static_cast<std::size_t>(x * channels + c)];
        to[x * channels + c] = static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  }
  return out;
}

}  // namespace armlet
