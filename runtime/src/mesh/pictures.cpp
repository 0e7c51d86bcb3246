#include "armlet/mesh/pictures.hpp"

namespace armlet {
namespace {

std::size_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t k = 0; k < count; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

std::optional<PictureSize> png_size(std::string_view bytes) {
  std::optional<PictureSize> size;
  for (std::size_t at = 8; bytes.size() >= at + 12;) {
    const std::size_t length = big_endian(bytes, at, 4);
    if (length > bytes.size() - at - 12) return std::nullopt;
    const std::string_view kind = bytes.substr(at + 4, 4);
    if (!size) {
      if (kind != "IHDR" || length != 13) return std::nullopt;
      size = PictureSize{big_endian(bytes, at + 8, 4), big_endian(bytes, at + 12, 4)};
    }
    if (kind == "IEND") return size;
    at += 12 + length;
  }
  return std::nullopt;
}

std::optional<PictureSize> jpeg_size(std::string_view bytes) {
  for (std::size_t at = 2; bytes.size() >= at + 4;) {
    if (bytes[at] != '\xff') return std::nullopt;
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2 || length > bytes.size() - at - 2) return std::nullopt;
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame && length >= 7)
      return PictureSize{big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
    if (marker == 0xda || is_frame) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace

std::string_view image_kind(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  return {};
}

std::optional<PictureSize> picture_size(std::string_view bytes) {
  const std::string_view kind = image_kind(bytes);
  if (kind.empty()) return std::nullopt;
  return kind == "image/png" ? png_size(bytes) : jpeg_size(bytes);
}

}  // namespace armlet
