#pragma once
// Pictures on surfaces.

#include <array>
#include <cstdint>
#include <vector>

#include "armlet/image/image.hpp"

namespace armlet {

// Red, green, blue from 0 to 1 in linear light, in which brightness can be added.
struct LinearRgb {
  float r = 0.0F, g = 0.0F, b = 0.0F;
  bool operator==(const LinearRgb&) const = default;
};

// Linear light of a byte of a picture; and the byte of linear light, which is clamped to 0 to 1.
//
// source  IEC 61966-2-1 (sRGB), 1999, section 5.2.
float linear_of(std::uint8_t byte);
std::uint8_t byte_of(float linear);
LinearRgb linear_rgb(std::uint8_t r, std::uint8_t g, std::uint8_t b);

// A picture with smaller copies of itself, each half as large as the one before, for drawing
// distant parts of a surface.
//
// source  L. Williams, Pyramidal parametrics, Computer Graphics 17(3), 1983.
class Texture {
 public:
  // throws  ArgumentError for a picture without pixels or a picture of depths.
  explicit Texture(const Image& picture);

  [[nodiscard]] int width() const { return levels_.front().width; }
  [[nodiscard]] int height() const { return levels_.front().height; }
  // A hash of its pixels, never 0.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

  // Values from 0 to 255 as in the picture, interpolated between pixels of the copy that has about
  // one pixel for each drawn pixel.
  //
  // u, v       0 to 1 from the upper left corner; beyond that the border values continue.
  // footprint  length of a drawn pixel, in pixels of the full-size picture.
  [[nodiscard]] std::array<float, 3> value(float u, float v, float footprint) const;

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
  };
  static Level half_of(const Level& whole);

  std::vector<Level> levels_;
  std::uint64_t fingerprint_ = 0;
};

}  // namespace armlet
