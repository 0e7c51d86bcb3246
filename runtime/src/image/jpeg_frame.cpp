#include <fmt/format.h>

#include <algorithm>

#include "image/read_formats.hpp"

namespace armlet {
namespace {

constexpr std::uint8_t kStartOfScan = 0xda;

// Frames of 0xc0 to 0xcf, without the tables DHT, JPG and DAC that have numbers among them.
bool is_frame(std::uint8_t marker) {
  return (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

std::string fault_of_frame(std::uint8_t marker, std::string_view segment, std::size_t file_size) {
  if (marker > 0xc2) {
    return fmt::format(
        "The JPEG file is of the kind SOF{} (lossless, hierarchical or arithmetic); expected "
        "baseline or progressive, SOF0 to SOF2.",
        marker - 0xc0);
  }
  if (segment.size() < 8)
    return fmt::format("The frame of the JPEG file has {} bytes; expected at least 8.",
                       segment.size());
  if (const std::uint32_t bits = big_endian(segment, 2, 1); bits != 8)
    return fmt::format("The JPEG file has {} bits a channel; expected 8.", bits);
  const std::uint64_t height = big_endian(segment, 3, 2);
  const std::uint64_t width = big_endian(segment, 5, 2);
  if (std::string fault = fault_of_size("JPEG", width, height); !fault.empty()) return fault;
  const std::uint32_t channels = big_endian(segment, 7, 1);
  if (channels != 1 && channels != 3 && channels != 4)
    return fmt::format("The JPEG file has {} channels; expected 1, 3 or 4.", channels);
  // A block of 8 x 8 pixels takes at least one bit.
  if (width * height / 512 > file_size) {
    return fmt::format(
        "The JPEG file says {} x {} pixels, which take at least {} bytes; it has {}.", width,
        height, width * height / 512, file_size);
  }
  return {};
}

}  // namespace

std::string fault_of_jpeg(std::string_view bytes) {
  std::size_t at = 2;
  bool has_frame = false;
  while (bytes.size() - at >= 4) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xff)
      return fmt::format("Byte {} of the JPEG file is {:02x}; expected the ff of a marker.", at,
                         static_cast<std::uint8_t>(bytes[at]));
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (marker == 0xff) {  // any number of them may stand before a marker
      ++at;
      continue;
    }
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2 || length > bytes.size() - at - 2) {
      return fmt::format("The part {:02x} at byte {} of the JPEG file says {} bytes; {} follow.",
                         marker, at, length, bytes.size() - at - 2);
    }
    if (is_frame(marker)) {
      has_frame = true;
      std::string fault = fault_of_frame(marker, bytes.substr(at + 2, length), bytes.size());
      if (!fault.empty()) return fault;
    }
    at += 2 + length;
    if (marker == kStartOfScan) break;
  }
  if (!has_frame) return fmt::format("The JPEG file of {} bytes has no frame (SOF).", bytes.size());
  if (bytes.find("\xff\xd9", std::min(at, bytes.size())) == std::string_view::npos)
    return fmt::format("The JPEG file ends at byte {} before its last marker ff d9.", bytes.size());
  return {};
}

}  // namespace armlet
