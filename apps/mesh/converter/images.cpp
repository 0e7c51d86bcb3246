// Pictures: which kinds are taken, and what is looked at before one is.

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "armlet/core/error.hpp"
#include "converter/scene_builder.hpp"

namespace armlet::mesh {
namespace {

constexpr std::size_t kMostBytes = std::size_t{32} << 20;
constexpr std::size_t kMostPixels = 8192;  // in each direction

using Size = std::pair<std::size_t, std::size_t>;

std::size_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t k = 0; k < count; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// Nothing: it is not whole. source  W3C, Portable Network Graphics, 2003, chapters 5 and 11.
std::optional<Size> png_size(std::string_view bytes) {
  std::optional<Size> size;
  for (std::size_t at = 8; bytes.size() >= at + 12;) {
    const std::size_t length = big_endian(bytes, at, 4);
    if (length > bytes.size() - at - 12) return std::nullopt;
    const std::string_view kind = bytes.substr(at + 4, 4);
    if (!size) {
      if (kind != "IHDR" || length != 13) return std::nullopt;
      size = Size{big_endian(bytes, at + 8, 4), big_endian(bytes, at + 12, 4)};
    }
    if (kind == "IEND") return size;
    at += 12 + length;
  }
  return std::nullopt;
}

// Nothing: it is not whole. source  ITU-T T.81, 1992, annex B.
std::optional<Size> jpeg_size(std::string_view bytes) {
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
      return Size{big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
    if (marker == 0xda || is_frame) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace

void check_image(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    throw ArgumentError(fmt::format("the picture \"{}\" {}", name, why));
  };
  if (bytes.size() > kMostBytes) {
    refuse(fmt::format("has {} bytes; expected {} MB at most", bytes.size(), kMostBytes >> 20));
  }
  const auto size = image_kind(bytes) == "image/png" ? png_size(bytes) : jpeg_size(bytes);
  if (!size) {
    refuse("is damaged or cut off");
  } else if (size->first == 0 || size->second == 0 || size->first > kMostPixels ||
             size->second > kMostPixels) {
    refuse(fmt::format("says it has {} x {} pixels; expected 1 to {} in each direction",
                       size->first, size->second, kMostPixels));
  }
}

std::optional<GlbImage> load_image(Files& files, const std::string& name,
                                   std::vector<std::string>& notes) {
  const GivenFile& file = files.find(name);
  switch (file.state) {
    case Say::kFile:
      break;
    case Say::kAbsent:
    case Say::kOutside:
      notes.push_back(fmt::format("the picture \"{}\" is left out: {}", name, file.text));
      return std::nullopt;
    default:
      throw ArgumentError(fmt::format("the picture \"{}\" cannot be read: {}", name, file.text));
  }
  if (image_kind(file.text).empty()) {
    notes.push_back(fmt::format("the picture \"{}\" is left out: it is no PNG and no JPEG", name));
    return std::nullopt;
  }
  check_image(file.text, name);
  return GlbImage{shown_text(name), file.text};
}

}  // namespace armlet::mesh
