// Figures that show a picture.

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/base64.hpp"
#include "armlet/image/plain_png.hpp"
#include "svg_parts.hpp"

namespace armlet::svg {

std::string picture(const Figure& figure, double& bottom) {
  constexpr double kRoom = kWidth - 36.0, kNote = 20.0, kLeast = 2.0;  // px
  const Image& image = *figure.picture;
  const double scale = std::min(kRoom / image.width(), kSpatialHeight / image.height());
  const double width = std::max(kLeast, scale * image.width());
  const double height = std::max(kLeast, scale * image.height());
  const double left = 0.5 * (kWidth - width), top = bottom;
  bottom += height + kNote + 6.0;
  // Pixels larger than those of the screen are drawn with sharp edges.
  return fmt::format(
             "<image x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" "
             "preserveAspectRatio=\"none\"{4} href=\"data:image/png;base64,{5}\"/>\n"
             "<rect class=\"frame\" x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\"/>\n",
             coordinate(left), coordinate(top), coordinate(width), coordinate(height),
             scale >= 2.0 ? " style=\"image-rendering:pixelated\"" : "",
             to_base64(plain_png(image))) +
         text({0.5 * kWidth, top + height + kNote - 4.0}, "middle", "note", figure.note);
}

}  // namespace armlet::svg
