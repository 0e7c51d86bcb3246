#pragma once
// Pictures: pixels in rows from the top, each row from the left, integers at pixel centres.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace armlet {

// The kind of pixels: one byte of grey, three of red, green and blue, or a depth in metres.
enum class PixelKind : std::uint8_t { kGrey, kRgb, kDepth };

// Grey or colour pixels of 8 bits, or depths as floats. The size never changes.
class Image {
 public:
  static constexpr int kMostSide = 8192;  // pixels

  Image() = default;  // without pixels
  // Black, or depths of 0.
  //
  // throws  ArgumentError for a side below 1 or above kMostSide.
  Image(int width, int height, PixelKind kind);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] PixelKind kind() const { return kind_; }
  [[nodiscard]] int channels() const { return kind_ == PixelKind::kRgb ? 3 : 1; }
  [[nodiscard]] bool is_empty() const { return width_ == 0; }

  // A row of a grey or colour picture, width * channels bytes; of a depth picture, width floats.
  [[nodiscard]] std::uint8_t* row(int y) { return bytes_.data() + offset(y); }
  [[nodiscard]] const std::uint8_t* row(int y) const { return bytes_.data() + offset(y); }
  [[nodiscard]] float* depth_row(int y) { return depths_.data() + offset(y); }
  [[nodiscard]] const float* depth_row(int y) const { return depths_.data() + offset(y); }

  // All rows, one directly after the other.
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }
  [[nodiscard]] std::span<const float> depths() const { return depths_; }

  bool operator==(const Image& other) const = default;

 private:
  [[nodiscard]] std::size_t offset(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * channels());
  }

  int width_ = 0;
  int height_ = 0;
  PixelKind kind_ = PixelKind::kGrey;
  std::vector<std::uint8_t> bytes_;
  std::vector<float> depths_;
};

}  // namespace armlet
