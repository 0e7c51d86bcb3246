#include "armlet/image/picture_size.hpp"

#include "image/read_formats.hpp"

namespace armlet {
namespace {

// Requires complete chunks up to the last one; checksums are not verified.
std::optional<PictureSize> png_size(std::string_view bytes) {
  const auto header = png_header(bytes);
  if (!header) return std::nullopt;
  for (std::size_t at = kPngSignature.size(); bytes.size() >= at + 12;) {
    const std::size_t length = big_endian(bytes, at, 4);
    if (length > bytes.size() - at - 12) return std::nullopt;
    if (bytes.substr(at + 4, 4) == "IEND")
      return PictureSize{static_cast<std::size_t>(header->width),
                         static_cast<std::size_t>(header->height)};
    at += 12 + length;
  }
  return std::nullopt;
}

std::optional<PictureSize> jpeg_size(std::string_view bytes) {
  for (std::size_t at = 2; bytes.size() >= at + 4;) {
    if (bytes[at] != '\xff') return std::nullopt;
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2 || length > bytes.size() - at - 2) return std::nullopt;
    if (is_jpeg_frame(marker) && length >= 7)
      return PictureSize{big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
    if (marker == 0xda || is_jpeg_frame(marker)) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PngHeader> png_header(std::string_view bytes) {
  constexpr std::size_t kFirst = kPngSignature.size();
  if (bytes.size() < kFirst + 25 || big_endian(bytes, kFirst, 4) != 13 ||
      bytes.substr(kFirst + 4, 4) != "IHDR")
    return std::nullopt;
  return PngHeader{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4), big_endian(bytes, 24, 1),
                   big_endian(bytes, 25, 1)};
}

std::string_view image_kind(std::string_view bytes) {
  if (bytes.starts_with(kPngSignature)) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  return {};
}

std::optional<PictureSize> picture_size(std::string_view bytes) {
  const std::string_view kind = image_kind(bytes);
  if (kind.empty()) return std::nullopt;
  return kind == "image/png" ? png_size(bytes) : jpeg_size(bytes);
}

}  // namespace armlet
