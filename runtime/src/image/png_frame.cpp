#include <fmt/format.h>
#include <zlib.h>

#include "armlet/core/checkpoint.hpp"
#include "image/read_formats.hpp"

namespace armlet {
namespace {

// The CRC of a chunk.
std::uint32_t checksum(std::string_view bytes) {
  checkpoint(bytes.size());
  const auto* const first = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32(0, first, static_cast<uInt>(bytes.size())));
}

std::string fault_of_header(const PngHeader& header, std::string_view bytes) {
  if (std::string fault = fault_of_size("PNG", header.width, header.height); !fault.empty())
    return fault;
  constexpr std::uint64_t kChannels[7] = {1, 0, 3, 1, 2, 0, 4};
  if (header.colour > 6 || kChannels[header.colour] == 0) {
    return fmt::format("The PNG file has the colour type {}; expected 0, 2, 3, 4 or 6.",
                       header.colour);
  }
  const std::uint64_t bits = header.width * header.height * header.depth * kChannels[header.colour];
  // Deflate expands a byte to at most 1032.
  if (bits / 8 / 1032 > bytes.size()) {
    return fmt::format("The PNG file says {} x {} pixels, which take at least {} bytes; it has {}.",
                       header.width, header.height, bits / 8 / 1032, bytes.size());
  }
  return {};
}

// The name of a chunk, with placeholders for bytes that are not letters.
std::string name_of(std::string_view chunk) {
  std::string name(chunk);
  for (char& letter : name)
    if ((letter | 0x20) < 'a' || (letter | 0x20) > 'z') letter = '?';
  return name;
}

}  // namespace

std::string fault_of_size(std::string_view format, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMost = Image::kMostSide;
  if (width >= 1 && height >= 1 && width <= kMost && height <= kMost) return {};
  return fmt::format("The {} file says {} x {} pixels; expected sides of 1 to {}.", format, width,
                     height, kMost);
}

std::string fault_of_png(std::string_view bytes) {
  const auto header = png_header(bytes);
  if (!header) {
    return fmt::format("The PNG file of {} bytes does not begin with the chunk IHDR of 25 bytes.",
                       bytes.size());
  }
  std::size_t at = kPngSignature.size();
  bool has_pixels = false;
  while (bytes.size() - at >= 12) {
    const std::size_t length = big_endian(bytes, at, 4);
    const std::string_view name = bytes.substr(at + 4, 4);
    if (length > bytes.size() - at - 12) {
      return fmt::format("The chunk {} at byte {} of the PNG file says {} bytes; {} follow.",
                         name_of(name), at, length, bytes.size() - at - 12);
    }
    const std::uint32_t given = big_endian(bytes, at + 8 + length, 4);
    const std::uint32_t computed = checksum(bytes.substr(at + 4, 4 + length));
    if (given != computed) {
      return fmt::format(
          "The chunk {} at byte {} of the PNG file is damaged: its checksum is {:08x}, "
          "its bytes give {:08x}.",
          name_of(name), at, given, computed);
    }
    if (name == "IDAT" && length == 0 && !has_pixels)
      return fmt::format("The first chunk IDAT at byte {} of the PNG file is empty.", at);
    has_pixels = has_pixels || name == "IDAT";
    if (name == "IEND")
      return has_pixels ? fault_of_header(*header, bytes) : "The PNG file has no chunk IDAT.";
    at += 12 + length;
  }
  return fmt::format("The PNG file ends at byte {} before its chunk IEND.", bytes.size());
}

}  // namespace armlet
