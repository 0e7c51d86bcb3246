#include "armlet/vision/template_match.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

// Whether every channel has one value.
bool is_flat(const Image& image) {
  const auto bytes = image.bytes();
  const auto channels = static_cast<std::size_t>(image.channels());
  for (std::size_t i = channels; i < bytes.size(); ++i)
    if (bytes[i] != bytes[i % channels]) return false;
  return true;
}

}  // namespace

TemplateMatch match_template(const Image& image, const Image& part) {
  check_door_picture("match", image, false);
  check_door_picture("match", part, false);
  if (image.kind() != part.kind())
    throw ArgumentError("One of picture and template is grey and the other RGB.");
  if (part.width() > image.width() || part.height() > image.height()) {
    throw ArgumentError(
        fmt::format("The template has {} x {} pixels, more than the {} x {} of the "
                    "picture.",
                    part.width(), part.height(), image.width(), image.height()));
  }
  if (is_flat(part))
    throw ArgumentError("The template has one brightness, which fits everywhere alike.");
  const OpencvResult found = call_opencv(
      &OpencvDoor::match, {.picture = door_picture(image), .other = door_picture(part)});
  return {.x = found.numbers[0] + 0.5 * (part.width() - 1),
          .y = found.numbers[1] + 0.5 * (part.height() - 1),
          .score = found.numbers[2]};
}

}  // namespace armlet
