#include "camera/raster/lens_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"

namespace armlet::raster {

void fit(Pictures& pictures, int width, int height, const PictureOptions& options) {
  const auto make = [&](Image& image, PixelKind kind) {
    if (image.width() != width || image.height() != height || image.kind() != kind)
      image = Image(width, height, kind);
  };
  if (options.color) make(pictures.color, PixelKind::kRgb);
  if (options.depth) make(pictures.depth, PixelKind::kDepth);
  if (options.bodies)
    pictures.bodies.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void LensTable::prepare(const Pinhole& camera) {
  const Intrinsics& i = camera.intrinsics();
  if (i == camera_) return;
  camera_.width = 0;  // until all is computed
  places_.resize(static_cast<std::size_t>(i.width) * static_cast<std::size_t>(i.height));
  std::vector<Eigen::Vector2d> pixels(places_.size());
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    const auto width = static_cast<std::size_t>(i.width);
    constexpr std::uint64_t kOfPixel = 100;  // operations
    if (n % width == 0) checkpoint(kOfPixel * width);
    const Result<Eigen::Vector2d> pixel =
        camera.undistort({static_cast<double>(n % width), static_cast<double>(n / width)});
    places_[n].x = pixel ? 0.0F : -1.0F;
    if (!pixel) continue;
    pixels[n] = pixel.value();
    left = std::min(left, pixels[n].x());
    right = std::max(right, pixels[n].x());
    top = std::min(top, pixels[n].y());
    bottom = std::max(bottom, pixels[n].y());
  }
  const double sides = std::max(right - left, bottom - top) + 4.0;
  if (!(sides <= Image::kMostSide)) {
    throw ArgumentError(fmt::format(
        "Without its distortion the picture of the camera would be {:.0f} pixels long; at most {} "
        "can be drawn. Smaller coefficients or a smaller picture help.",
        sides, Image::kMostSide));
  }
  wide_ = i;
  wide_.distortion = {};
  const double shift_x = 1.0 - std::floor(left), shift_y = 1.0 - std::floor(top);
  wide_.cx += shift_x;
  wide_.cy += shift_y;
  wide_.width = static_cast<int>(std::ceil(right) + shift_x) + 2;
  wide_.height = static_cast<int>(std::ceil(bottom) + shift_y) + 2;
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    if (places_[n].x < 0.0F) continue;
    places_[n] = {static_cast<float>(pixels[n].x() + shift_x),
                  static_cast<float>(pixels[n].y() + shift_y)};
  }
  camera_ = i;
}

void LensTable::color_row(const Image& wide, int y, std::uint8_t* out) const {
  const Place* place =
      places_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width);
  for (int x = 0; x < camera_.width; ++x, ++place, out += 3) {
    if (place->x < 0.0F) {
      std::fill_n(out, 3, std::uint8_t{0});
      continue;
    }
    const int column = static_cast<int>(place->x), row = static_cast<int>(place->y);
    const float right = place->x - static_cast<float>(column);
    const float below = place->y - static_cast<float>(row);
    const std::uint8_t* above = wide.row(row) + 3 * column;
    const std::uint8_t* under = wide.row(row + 1) + 3 * column;
    for (int c = 0; c < 3; ++c) {
      const float a =
          static_cast<float>(above[c]) + right * static_cast<float>(above[c + 3] - above[c]);
      const float b =
          static_cast<float>(under[c]) + right * static_cast<float>(under[c + 3] - under[c]);
      out[c] = static_cast<std::uint8_t>(a + below * (b - a) + 0.5F);
    }
  }
}

void LensTable::resample(const Pictures& wide, const PictureOptions& options, Pictures& out) const {
  const int height = camera_.height;
  fit(out, camera_.width, height, options);
  if (options.color) {
    for (int y = 0; y < height; ++y) color_row(wide.color, y, out.color.row(y));
  }
  if (!options.depth && !options.bodies) return;
  for (std::size_t n = 0; n < places_.size(); ++n) {
    const Place& place = places_[n];
    const bool has_ray = place.x >= 0.0F;
    const int column = has_ray ? static_cast<int>(place.x + 0.5F) : 0;
    const int row = has_ray ? static_cast<int>(place.y + 0.5F) : 0;
    if (options.depth)
      out.depth.depth_row(0)[n] = has_ray ? wide.depth.depth_row(row)[column] : 0.0F;
    if (options.bodies)
      out.bodies[n] =
          has_ray ? wide.bodies[static_cast<std::size_t>(row * wide_.width + column)] : kNoBody;
  }
}

}  // namespace armlet::raster
