// Pictures: the formats that are accepted, and the checks before one is used.

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/image/picture_size.hpp"
#include "converter/scene_builder.hpp"

namespace armlet::mesh {
namespace {

constexpr std::size_t kMostImageBytes = std::size_t{32} << 20;

}  // namespace

void check_image(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    throw ArgumentError(fmt::format("the picture \"{}\" {}", name, why));
  };
  if (bytes.size() > kMostImageBytes) {
    refuse(
        fmt::format("has {} bytes; expected {} MB at most", bytes.size(), kMostImageBytes >> 20));
  }
  const auto size = picture_size(bytes);
  if (!size) {
    refuse("is damaged or cut off");
  } else if (!size->is_usable()) {
    refuse(fmt::format("says it has {} x {} pixels; expected 1 to {} in each direction",
                       size->width, size->height, kMostPixels));
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
