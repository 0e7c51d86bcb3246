#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

inline constexpr const char* kPictureCode = "picture";

// A number of `count` bytes, the highest first.
inline std::uint32_t big_endian(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// The first chunk of a PNG, behind the signature; nothing if there is another one or it is cut off.
struct PngHeader {
  std::uint64_t width;
  std::uint64_t height;
  std::uint32_t depth;   // bits of a channel
  std::uint32_t colour;  // 0 grey, 2 RGB, 3 palette, 4 and 6 with opacity
};
std::optional<PngHeader> png_header(std::string_view bytes);

// Whether a part of a JPEG says how large it is: 0xc0 to 0xcf, without the tables DHT, JPG and DAC
// that have numbers among them.
inline bool is_jpeg_frame(std::uint8_t marker) {
  return (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// The error for sides that no Image can have, or nothing.
std::string fault_of_size(std::string_view format, std::uint64_t width, std::uint64_t height);

// What is wrong with the frame of a file around its compressed pixels: lengths, checksums, sizes.
// Empty if nothing is.
std::string fault_of_png(std::string_view bytes);
std::string fault_of_jpeg(std::string_view bytes);

// The pixels of a file whose frame is sound.
Result<Image> decode_png_or_jpeg(std::string_view format, std::string_view bytes);

Result<Image> read_netpbm(std::string_view bytes);

}  // namespace armlet
