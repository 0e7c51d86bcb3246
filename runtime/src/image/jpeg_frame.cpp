#include <fmt/format.h>

#include <algorithm>

#include "image/read_formats.hpp"

namespace armlet {
namespace {

constexpr std::uint8_t kHuffman = 0xc4;
constexpr std::uint8_t kEnd = 0xd9;
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

// The codes of Huffman tables: 16 counts, then as many symbols. The decoder would write beyond its
// tables where there are more than 256.
std::string fault_of_tables(std::string_view segment, std::size_t position) {
  for (std::size_t at = 2; at < segment.size();) {
    if (segment.size() - at < 17)
      return fmt::format("The Huffman table at byte {} of the JPEG file has {} bytes; expected 17.",
                         position + at, segment.size() - at);
    std::size_t codes = 0;
    for (std::size_t i = 1; i <= 16; ++i) codes += static_cast<std::uint8_t>(segment[at + i]);
    if (codes > 256 || codes > segment.size() - at - 17) {
      return fmt::format(
          "The Huffman table at byte {} of the JPEG file says {} codes; expected at most {}.",
          position + at, codes, std::min<std::size_t>(256, segment.size() - at - 17));
    }
    at += 17 + codes;
  }
  return {};
}

// Where the next marker is behind compressed pixels, in which ff stands before 0 or a restart.
std::size_t next_marker(std::string_view bytes, std::size_t at) {
  for (; at + 1 < bytes.size(); ++at) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xff) continue;
    const auto next = static_cast<std::uint8_t>(bytes[at + 1]);
    if (next != 0 && next != 0xff && (next & 0xf8) != 0xd0) return at;
  }
  return bytes.size();
}

std::string fault_of_segment(std::uint8_t marker, std::string_view segment, std::size_t position,
                             std::size_t file_size) {
  if (is_frame(marker)) return fault_of_frame(marker, segment, file_size);
  return marker == kHuffman ? fault_of_tables(segment, position) : std::string();
}

}  // namespace

std::string fault_of_jpeg(std::string_view bytes) {
  std::size_t at = 2;
  bool has_frame = false;
  while (bytes.size() - at >= 4) {
    const auto first = static_cast<std::uint8_t>(bytes[at]);
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (first != 0xff)
      return fmt::format("Byte {} of the JPEG file is {:02x}; expected the ff of a marker.", at,
                         first);
    if (marker == 0xff) {  // any number of them may stand before a marker
      ++at;
      continue;
    }
    if (marker == kEnd) break;
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2 || length > bytes.size() - at - 2) {
      return fmt::format("The part {:02x} at byte {} of the JPEG file says {} bytes; {} follow.",
                         marker, at, length, bytes.size() - at - 2);
    }
    const std::string_view segment = bytes.substr(at + 2, length);
    std::string fault = fault_of_segment(marker, segment, at + 2, bytes.size());
    if (!fault.empty()) return fault;
    has_frame = has_frame || is_frame(marker);
    at += 2 + length;
    if (marker == kStartOfScan) at = next_marker(bytes, at);
  }
  if (!has_frame) return fmt::format("The JPEG file of {} bytes has no frame (SOF).", bytes.size());
  if (bytes.substr(std::min(at, bytes.size()), 2) != "\xff\xd9")
    return fmt::format("The JPEG file ends at byte {} before its last marker ff d9.", bytes.size());
  return {};
}

}  // namespace armlet
