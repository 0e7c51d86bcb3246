#include "camera/raster/bands.hpp"

namespace armlet::raster {

BandLists::Rows BandLists::bands_of(const DrawnTriangle& triangle) const {
  const auto [low, high] =
      std::minmax({triangle.corners.y[0], triangle.corners.y[1], triangle.corners.y[2]});
  const auto band_of = [&](std::int32_t y) {
    return static_cast<int>(
        floor_quotient(floor_quotient(y, kOne) - window_.top, std::int64_t{kBandRows}));
  };
  // One pixel more on both sides, because samples are not at the centres of pixels.
  return {std::max(0, band_of(low - kOne)), std::min(bands_ - 1, band_of(high + kOne))};
}

void BandLists::sort(const std::vector<DrawnTriangle>& triangles, const Window& window) {
  window_ = window;
  bands_ = (window.height + kBandRows - 1) / kBandRows;
  starts_.assign(static_cast<std::size_t>(bands_) + 1, 0);
  for (const DrawnTriangle& triangle : triangles) {
    const Rows rows = bands_of(triangle);
    for (int band = rows.first; band <= rows.last; ++band)
      ++starts_[static_cast<std::size_t>(band) + 1];
  }
  for (std::size_t band = 1; band < starts_.size(); ++band) starts_[band] += starts_[band - 1];
  items_.resize(starts_.back());
  next_.assign(starts_.begin(), starts_.end());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Rows rows = bands_of(triangles[i]);
    for (int band = rows.first; band <= rows.last; ++band)
      items_[next_[static_cast<std::size_t>(band)]++] = static_cast<std::uint32_t>(i);
  }
}

void Band::draw(int band, const BandLists& lists, const std::vector<DrawnTriangle>& triangles,
                const Window& window, int samples, const GroundView& ground, double far) {
  grid_ = SampleGrid::of_picture(window.left, window.top, window.width, window.height, samples);
  const int per_pixel = samples == 4 ? 2 : 1;
  first_row_ = band * kBandRows;
  pixel_rows_ = std::min(kBandRows, window.height - first_row_);
  rows_.resize(grid_.columns, kBandRows * per_pixel, true);
  const int begin = first_row_ * per_pixel, end = begin + pixel_rows_ * per_pixel;
  clear(begin, end, ground, far);
  lists.for_each(band,
                 [&](std::uint32_t i) { fill<true>(triangles[i], grid_, begin, end, rows_); });
}

// The ground is drawn a few millionths of its distance farther away, so that a sheet on it is
// visible.
void Band::clear(int begin, int end, const GroundView& ground, double far) {
  constexpr double kBehind = 1.0 - 2e-6;
  const F4 farthest = F4{} + static_cast<float>(1.0 / far);
  const auto slope = static_cast<float>(ground.nearness.a * grid_.step * (kBehind / kOne));
  for (int row = begin; row < end; ++row) {
    float* nearness = rows_.nearness.data() + static_cast<std::size_t>(row - begin) * rows_.stride;
    std::int32_t* number =
        rows_.number.data() + static_cast<std::size_t>(row - begin) * rows_.stride;
    const F4 start =
        F4{} + static_cast<float>(kBehind * ground.nearness.at(grid_.u(0), grid_.v(row)));
    for (int column = 0; column < grid_.columns; column += 4) {
      const F4 value = start + slope * __builtin_convertvector(kCount + column, F4);
      const I4 is_ground = ground.is_seen ? I4(value > farthest) : I4{};
      store4(nearness + column, is_ground ? value : farthest);
      store4(number + column, is_ground ? I4{} + kGroundNumber : I4{} + kBackground);
    }
  }
}

}  // namespace armlet::raster
