#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

inline constexpr const char* kPictureCode = "picture";

// A big-endian number of `count` bytes.
inline std::uint32_t big_endian(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// The first chunk of a PNG, after the signature; nothing if it is another one or incomplete.
struct PngHeader {
  std::uint64_t width;
  std::uint64_t height;
  std::uint32_t depth;   // bits of a channel
  std::uint32_t colour;  // 0 grey, 2 RGB, 3 palette, 4 and 6 with opacity
};
std::optional<PngHeader> png_header(std::string_view bytes);

// Whether a segment of a JPEG contains the size: 0xc0 to 0xcf, except the tables DHT, JPG and DAC
// in that range.
inline bool is_jpeg_frame(std::uint8_t marker) {
  return (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// The error for a size that no Image can have; empty if it can.
std::string fault_of_size(std::string_view format, std::uint64_t width, std::uint64_t height);

// The error in the structure of a file around its compressed pixels (lengths, checksums, sizes);
// empty if there is none.
std::string fault_of_png(std::string_view bytes);
std::string fault_of_jpeg(std::string_view bytes);

// Decodes the pixels of a file whose structure has been checked.
Result<Image> decode_png_or_jpeg(std::string_view format, std::string_view bytes);

Result<Image> read_netpbm(std::string_view bytes);

}  // namespace armlet
