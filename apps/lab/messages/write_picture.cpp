// Pictures of elements, for pages.

#include <algorithm>
#include <cstring>

#include "json_parts.hpp"
#include "write_message.hpp"

namespace armlet::lab {
namespace {

// Depths as grey pixels, the nearest white; black where there is no depth.
std::vector<std::uint8_t> grey_of_depths(const Image& image) {
  const std::span<const float> depths = image.depths();
  float near = 0.0F, far = 0.0F;
  for (const float depth : depths) {
    if (!(depth > 0.0F)) continue;
    near = near == 0.0F ? depth : std::min(near, depth);
    far = std::max(far, depth);
  }
  std::vector<std::uint8_t> grey;
  grey.reserve(depths.size());
  constexpr float kDarkest = 30.0F, kLightest = 255.0F;
  const float range = std::max(far - near, 1e-6F);
  for (const float depth : depths) {
    const float level = kLightest - (kLightest - kDarkest) * (depth - near) / range;
    grey.push_back(depth > 0.0F ? static_cast<std::uint8_t>(level + 0.5F) : std::uint8_t{0});
  }
  return grey;
}

}  // namespace

Message write_picture(std::uint32_t to, const LabPicture& picture) {
  const Image& image = picture.image;
  OrderedJson told = {{"marks", OrderedJson::array()}, {"fault", picture.fault}};
  for (const LabMarks& marks : picture.marks)
    told["marks"].push_back(
        {{"what", marks.what}, {"object", marks.object}, {"pixels", marks.pixels}});
  const std::string text = told.dump();
  const std::uint32_t head[6] = {kPictureMessage,
                                 to,
                                 static_cast<std::uint32_t>(image.channels()),
                                 static_cast<std::uint32_t>(image.width()),
                                 static_cast<std::uint32_t>(image.height()),
                                 static_cast<std::uint32_t>(text.size())};
  Message out{std::string(sizeof head, '\0'), true};
  std::memcpy(out.bytes.data(), head, sizeof head);
  if (image.kind() == PixelKind::kDepth) {
    const std::vector<std::uint8_t> grey = grey_of_depths(image);
    out.bytes.append(reinterpret_cast<const char*>(grey.data()), grey.size());
  } else {
    out.bytes.append(reinterpret_cast<const char*>(image.bytes().data()), image.bytes().size());
  }
  out.bytes += text;
  return out;
}

}  // namespace armlet::lab
