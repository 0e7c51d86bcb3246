#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "image/read_formats.hpp"

namespace armlet {
namespace {

constexpr std::uint8_t kHuffman = 0xc4;
constexpr std::uint8_t kEnd = 0xd9;
constexpr std::uint8_t kStartOfScan = 0xda;
constexpr std::uint8_t kQuantisation = 0xdb;

// The contents of a file so far: its frame, and the tables that its scans use.
struct Parts {
  std::size_t file_size;
  bool has_frame = false;
  bool is_progressive = false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> components{};  // id, its quantisation table
  bool has_quantisers[4] = {};
  bool has_codes[2][4] = {};  // of DC coefficients, of AC coefficients
};

std::string fault_of_frame(std::uint8_t marker, std::string_view segment, Parts& parts) {
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
  if (segment.size() != 8 + 3 * channels)
    return fmt::format("The frame of the JPEG file has {} bytes; expected {} for {} channels.",
                       segment.size(), 8 + 3 * channels, channels);
  // A block of 8 x 8 pixels takes at least one bit.
  if (width * height / 512 > parts.file_size) {
    return fmt::format(
        "The JPEG file says {} x {} pixels, which take at least {} bytes; it has {}.", width,
        height, width * height / 512, parts.file_size);
  }
  for (std::size_t at = 8; at < segment.size(); at += 3)
    parts.components.emplace_back(big_endian(segment, at, 1), big_endian(segment, at + 2, 1));
  parts.has_frame = true;
  parts.is_progressive = marker == 0xc2;
  return {};
}

// Checks Huffman tables: 16 counts, then as many symbols. With more than 256 the decoder would
// write beyond its tables.
std::string fault_of_codes(std::string_view segment, std::size_t position, Parts& parts) {
  for (std::size_t at = 2; at < segment.size();) {
    if (segment.size() - at < 17)
      return fmt::format("The Huffman table at byte {} of the JPEG file has {} bytes; expected 17.",
                         position + at, segment.size() - at);
    const std::uint32_t number = big_endian(segment, at, 1);
    if (number / 16 > 1 || number % 16 > 3)
      return fmt::format(
          "The Huffman table at byte {} of the JPEG file has the number {:02x}; "
          "expected 00 to 03 or 10 to 13.",
          position + at, number);
    std::size_t codes = 0;
    for (std::size_t i = 1; i <= 16; ++i) codes += static_cast<std::uint8_t>(segment[at + i]);
    if (codes > 256 || codes > segment.size() - at - 17) {
      return fmt::format(
          "The Huffman table at byte {} of the JPEG file says {} codes; expected at most {}.",
          position + at, codes, std::min<std::size_t>(256, segment.size() - at - 17));
    }
    parts.has_codes[number / 16][number % 16] = true;
    at += 17 + codes;
  }
  return {};
}

// Checks quantisation tables: 64 numbers of one byte or two.
std::string fault_of_quantisers(std::string_view segment, std::size_t position, Parts& parts) {
  for (std::size_t at = 2; at < segment.size();) {
    const std::uint32_t number = big_endian(segment, at, 1);
    const std::size_t size = number / 16 == 0 ? 65 : 129;
    if (number / 16 > 1 || number % 16 > 3 || size > segment.size() - at) {
      return fmt::format(
          "The quantisation table at byte {} of the JPEG file has the number {:02x} "
          "and {} bytes; expected 00 to 03 and 65, or 10 to 13 and 129.",
          position + at, number, segment.size() - at);
    }
    parts.has_quantisers[number % 16] = true;
    at += size;
  }
  return {};
}

std::string missing_table(std::string_view kind, std::uint32_t number, std::size_t position) {
  return fmt::format(
      "The scan at byte {} of the JPEG file needs the {} table {}, which no part "
      "before it has.",
      position, kind, number);
}

// A scan may only use tables that are defined before it; otherwise the decoder would read undefined
// ones.
std::string fault_of_scan(std::string_view segment, std::size_t position, const Parts& parts) {
  if (!parts.has_frame)
    return fmt::format("The scan at byte {} of the JPEG file stands before its frame.", position);
  const std::size_t count = segment.size() < 6 ? 0 : big_endian(segment, 2, 1);
  if (count == 0 || segment.size() != 6 + 2 * count)
    return fmt::format("The scan at byte {} of the JPEG file has {} bytes; expected {}.", position,
                       segment.size(), 6 + 2 * std::max<std::size_t>(count, 1));
  const std::size_t end = segment.size();
  const bool has_means = big_endian(segment, end - 3, 1) == 0;
  const bool has_others = !parts.is_progressive || big_endian(segment, end - 2, 1) > 0;
  const bool is_first = big_endian(segment, end - 1, 1) / 16 == 0;
  for (std::size_t at = 3; at + 3 < end; at += 2) {
    const auto is_meant = [&](const auto& part) {
      return part.first == big_endian(segment, at, 1);
    };
    const auto component = std::ranges::find_if(parts.components, is_meant);
    if (component == parts.components.end())
      return fmt::format(
          "The scan at byte {} of the JPEG file is of the channel {}, which its "
          "frame does not have.",
          position, big_endian(segment, at, 1));
    if (component->second > 3 || !parts.has_quantisers[component->second])
      return missing_table("quantisation", component->second, position);
    const std::uint32_t means = big_endian(segment, at + 1, 1) / 16;
    const std::uint32_t others = big_endian(segment, at + 1, 1) % 16;
    if (has_means && is_first && (means > 3 || !parts.has_codes[0][means]))
      return missing_table("Huffman", means, position);
    if (has_others && (others > 3 || !parts.has_codes[1][others]))
      return missing_table("Huffman", 0x10 + others, position);
  }
  return {};
}

// Position of the next marker after compressed pixels, in which ff is followed by 0 or a restart.
std::size_t next_marker(std::string_view bytes, std::size_t at) {
  for (; at + 1 < bytes.size(); ++at) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xff) continue;
    const auto next = static_cast<std::uint8_t>(bytes[at + 1]);
    if (next != 0 && next != 0xff && (next & 0xf8) != 0xd0) return at;
  }
  return bytes.size();
}

std::string fault_of_segment(std::uint8_t marker, std::string_view segment, std::size_t position,
                             Parts& parts) {
  if (is_jpeg_frame(marker)) return fault_of_frame(marker, segment, parts);
  if (marker == kHuffman) return fault_of_codes(segment, position, parts);
  if (marker == kQuantisation) return fault_of_quantisers(segment, position, parts);
  return marker == kStartOfScan ? fault_of_scan(segment, position, parts) : std::string();
}

}  // namespace

std::string fault_of_jpeg(std::string_view bytes) {
  std::size_t at = 2;
  Parts parts{.file_size = bytes.size()};
  while (bytes.size() - at >= 4) {
    const auto first = static_cast<std::uint8_t>(bytes[at]);
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (first != 0xff)
      return fmt::format("Byte {} of the JPEG file is {:02x}; expected the ff of a marker.", at,
                         first);
    if (marker == 0xff) {  // any number of them may precede a marker
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
    std::string fault = fault_of_segment(marker, segment, at + 2, parts);
    if (!fault.empty()) return fault;
    at += 2 + length;
    if (marker == kStartOfScan) at = next_marker(bytes, at);
  }
  if (!parts.has_frame)
    return fmt::format("The JPEG file of {} bytes has no frame (SOF).", bytes.size());
  if (bytes.substr(std::min(at, bytes.size()), 2) != "\xff\xd9")
    return fmt::format("The JPEG file ends at byte {} before its last marker ff d9.", bytes.size());
  return {};
}

}  // namespace armlet
