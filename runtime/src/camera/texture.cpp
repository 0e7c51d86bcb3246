#include "armlet/camera/texture.hpp"

#include <algorithm>
#include <bit>

#include "armlet/core/error.hpp"
#include "armlet/core/hash.hpp"
#include "armlet/math/det_math.hpp"
#include "camera/raster/srgb_tables.hpp"

namespace armlet {
namespace raster {
namespace {

double decoded(double value) {
  return value <= 0.04045 ? value / 12.92 : det::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * det::pow(linear, 1.0 / 2.4) - 0.055;
}

SrgbTables make_tables() {
  SrgbTables tables;
  for (int i = 0; i <= SrgbTables::kDecodeSteps; ++i)
    tables.decode[static_cast<std::size_t>(i)] =
        static_cast<float>(decoded(static_cast<double>(i) / SrgbTables::kDecodeSteps));
  for (int i = 0; i <= SrgbTables::kEncodeSteps; ++i)
    tables.encode[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
        255.0 * encoded(static_cast<double>(i) / SrgbTables::kEncodeSteps) + 0.5);
  return tables;
}

}  // namespace

const SrgbTables& srgb_tables() {
  static const SrgbTables tables = make_tables();
  return tables;
}

}  // namespace raster

float linear_of(std::uint8_t byte) {
  return raster::srgb_tables().decode[byte * std::size_t{raster::SrgbTables::kPerByte}];
}

std::uint8_t byte_of(float linear) { return raster::encoded_byte(raster::srgb_tables(), linear); }

LinearRgb linear_rgb(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  return {linear_of(r), linear_of(g), linear_of(b)};
}

Texture::Texture(const Image& picture) {
  if (picture.is_empty()) throw ArgumentError("A picture on a surface has no pixels.");
  if (picture.kind() == PixelKind::kDepth)
    throw ArgumentError("A picture on a surface is grey or coloured, not one of depths.");
  Level level{.width = picture.width(), .height = picture.height(), .rgb = {}};
  level.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(level.width * level.height));
  const int channels = picture.channels();
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) {
      for (int c = 0; c < 3; ++c)
        level.rgb.push_back(picture.row(y)[x * channels + (channels == 3 ? c : 0)]);
    }
  }
  Fnv1a hash;
  hash.add(level.width);
  hash.add_bytes({reinterpret_cast<const char*>(level.rgb.data()), level.rgb.size()});
  fingerprint_ = hash.value() | 1U;
  levels_.push_back(std::move(level));
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(half_of(levels_.back()));
}

// The mean of two by two pixels; the last column or row of an odd side is repeated.
Texture::Level Texture::half_of(const Level& whole) {
  Level half{.width = (whole.width + 1) / 2, .height = (whole.height + 1) / 2, .rgb = {}};
  half.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(half.width * half.height));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const int right = std::min(2 * x + 1, whole.width - 1);
      const int below = std::min(2 * y + 1, whole.height - 1);
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int column, int row) {
          return static_cast<int>(
              whole.rgb[static_cast<std::size_t>(3 * (row * whole.width + column) + c)]);
        };
        half.rgb.push_back(static_cast<std::uint8_t>(
            (at(2 * x, 2 * y) + at(right, 2 * y) + at(2 * x, below) + at(right, below) + 2) / 4));
      }
    }
  }
  return half;
}

std::array<float, 3> Texture::value(float u, float v, float footprint) const {
  // Half the exponent of the square is the level whose pixels are about as long as the footprint.
  const float square = std::clamp(footprint * footprint, 1.0F, 1e12F) * 2.0F;
  const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(square) >> 23U) - 127;
  const auto number = std::min(static_cast<std::size_t>(exponent / 2), levels_.size() - 1);
  const Level& level = levels_[number];
  const auto position = [](float t, int size) {
    return std::clamp(t * static_cast<float>(size) - 0.5F, 0.0F, static_cast<float>(size - 1));
  };
  const float x = position(u, level.width), y = position(v, level.height);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.width - 1), y1 = std::min(y0 + 1, level.height - 1);
  const float right = x - static_cast<float>(x0), below = y - static_cast<float>(y0);
  const auto texel = [&](int column, int row) {
    return level.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(row) * level.width + column);
  };
  const std::uint8_t *a = texel(x0, y0), *b = texel(x1, y0), *c = texel(x0, y1), *d = texel(x1, y1);
  std::array<float, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const float above = static_cast<float>(a[k]) + right * static_cast<float>(b[k] - a[k]);
    const float under = static_cast<float>(c[k]) + right * static_cast<float>(d[k] - c[k]);
    result[k] = above + below * (under - above);
  }
  return result;
}

}  // namespace armlet
