#include "armlet/vision/harris.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"

namespace armlet {
namespace {

constexpr double kGradientScale = 1.0 / 3060.0;  // Sobel 4, nine pixels, 255 grey levels

// The pixel at position i of n of the picture mirrored about its border.
int mirrored(int i, int n) {
  if (n == 1) return 0;
  return i < 0 ? -i : i >= n ? 2 * n - 2 - i : i;
}

// Elements of M for one pixel, or their sums for a row.
struct Moments {
  std::int32_t xx = 0;
  std::int32_t xy = 0;
  std::int32_t yy = 0;
};

// Computes responses row by row; stores three rows of products of gradients.
class ResponseRows {
 public:
  ResponseRows(const Image& grey, double sensitivity)
      : grey_(grey), width_(grey.width()), height_(grey.height()), sensitivity_(sensitivity) {
    for (auto& row : products_) row.resize(static_cast<std::size_t>(width_));
    columns_.resize(static_cast<std::size_t>(width_));
    for (int y = 0; y < std::min(2, height_); ++y) compute_products(y);
  }

  // To be called for y = 0, 1, 2 ... in this order. Writes `width` responses.
  void compute(int y, double* responses) {
    if (y > 0 && y + 1 < height_) compute_products(y + 1);
    const auto& above = products_row(mirrored(y - 1, height_));
    const auto& here = products_row(y);
    const auto& below = products_row(mirrored(y + 1, height_));
    for (std::size_t x = 0; x < columns_.size(); ++x) {
      columns_[x] = {above[x].xx + here[x].xx + below[x].xx, above[x].xy + here[x].xy + below[x].xy,
                     above[x].yy + here[x].yy + below[x].yy};
    }
    for (int x = 0; x < width_; ++x) responses[x] = response_at(x);
  }

 private:
  std::vector<Moments>& products_row(int y) { return products_[static_cast<std::size_t>(y % 3)]; }

  void compute_products(int y) {
    const std::uint8_t* above = grey_.row(mirrored(y - 1, height_));
    const std::uint8_t* here = grey_.row(y);
    const std::uint8_t* below = grey_.row(mirrored(y + 1, height_));
    std::vector<Moments>& out = products_row(y);
    for (int x = 0; x < width_; ++x) {
      const int left = mirrored(x - 1, width_);
      const int right = mirrored(x + 1, width_);
      const int gx = above[right] + 2 * here[right] + below[right] - above[left] - 2 * here[left] -
                     below[left];
      const int gy =
          below[left] + 2 * below[x] + below[right] - above[left] - 2 * above[x] - above[right];
      out[static_cast<std::size_t>(x)] = {gx * gx, gx * gy, gy * gy};
    }
  }

  [[nodiscard]] double response_at(int x) const {
    const Moments& l = columns_[static_cast<std::size_t>(mirrored(x - 1, width_))];
    const Moments& c = columns_[static_cast<std::size_t>(x)];
    const Moments& r = columns_[static_cast<std::size_t>(mirrored(x + 1, width_))];
    const std::int64_t xx = l.xx + c.xx + r.xx;
    const std::int64_t xy = l.xy + c.xy + r.xy;
    const std::int64_t yy = l.yy + c.yy + r.yy;
    // Below 2^53, so both are exact as doubles.
    const auto determinant = static_cast<double>(xx * yy - xy * xy);
    const auto square = static_cast<double>((xx + yy) * (xx + yy));
    constexpr double kScale = kGradientScale * kGradientScale;
    return (determinant - sensitivity_ * square) * (kScale * kScale);
  }

  const Image& grey_;
  int width_;
  int height_;
  double sensitivity_;
  std::array<std::vector<Moments>, 3> products_;
  std::vector<Moments> columns_;
};

bool is_largest_of_neighbours(const double* above, const double* here, const double* below) {
  for (const double* row : {above, here, below})
    for (int dx = -1; dx <= 1; ++dx)
      if (row[dx] > *here) return false;
  return true;
}

// All positive local maxima above the share of the largest response.
std::vector<HarrisCorner> local_maxima(const Image& grey, const HarrisOptions& options) {
  ResponseRows rows(grey, options.sensitivity);
  const auto width = static_cast<std::size_t>(grey.width());
  std::array<std::vector<double>, 3> ring;
  for (auto& row : ring) row.resize(width);
  std::vector<HarrisCorner> corners;
  double strongest = 0.0;
  for (int y = 0; y < grey.height(); ++y) {
    checkpoint(20 * width);
    std::vector<double>& below = ring[static_cast<std::size_t>(y % 3)];
    rows.compute(y, below.data());
    strongest = std::max(strongest, *std::max_element(below.begin(), below.end()));
    if (y < 2) continue;
    const double* above = ring[static_cast<std::size_t>((y - 2) % 3)].data();
    const double* here = ring[static_cast<std::size_t>((y - 1) % 3)].data();
    for (int x = 1; x + 1 < grey.width(); ++x) {
      if (here[x] > 0.0 && is_largest_of_neighbours(above + x, here + x, below.data() + x))
        corners.push_back({x, y - 1, here[x]});
    }
  }
  const double least = options.quality * strongest;
  std::erase_if(corners, [least](const HarrisCorner& corner) { return corner.response <= least; });
  return corners;
}

// Corners in square cells at least as wide as the least distance, so that only nine cells have to
// be searched.
class Cells {
 public:
  Cells(const Image& image, double distance)
      : squared_distance_(distance * distance),
        side_(std::max(kLeastSide, static_cast<int>(std::ceil(distance)))),
        columns_(image.width() / side_ + 1),
        rows_(image.height() / side_ + 1),
        first_(static_cast<std::size_t>(columns_ * rows_), -1) {}

  [[nodiscard]] bool has_near(const std::vector<HarrisCorner>& kept, const HarrisCorner& c) const {
    const int column = c.x / side_;
    const int row = c.y / side_;
    for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
        for (int i = first_[index(x, y)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
          const HarrisCorner& other = kept[static_cast<std::size_t>(i)];
          const int dx = c.x - other.x;
          const int dy = c.y - other.y;
          if (dx * dx + dy * dy < squared_distance_) return true;
        }
      }
    }
    return false;
  }

  // To be called for the corners 0, 1, 2 ... in this order.
  void add(const HarrisCorner& corner) {
    int& first = first_[index(corner.x / side_, corner.y / side_)];
    next_.push_back(first);
    first = static_cast<int>(next_.size()) - 1;
  }

 private:
  static constexpr int kLeastSide = 16;  // px; smaller cells would only need memory

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  double squared_distance_;
  int side_;
  int columns_;
  int rows_;
  std::vector<int> first_;
  std::vector<int> next_;
};

}  // namespace

std::vector<HarrisCorner> harris_corners(const Image& grey, const HarrisOptions& options) {
  check_grey("harris_corners", grey);
  check_picture_parameter("corners", "quality", options.quality);
  check_picture_parameter("corners", "distance", options.distance);
  check_picture_parameter("corners", "sensitivity", options.sensitivity);
  check_picture_parameter("corners", "max", options.max);
  std::vector<HarrisCorner> corners = local_maxima(grey, options);
  std::sort(corners.begin(), corners.end(), [](const HarrisCorner& a, const HarrisCorner& b) {
    return std::tuple(-a.response, a.y, a.x) < std::tuple(-b.response, b.y, b.x);
  });
  std::vector<HarrisCorner> kept;
  Cells cells(grey, options.distance);
  for (const HarrisCorner& corner : corners) {
    if (options.max > 0 && kept.size() == static_cast<std::size_t>(options.max)) break;
    if (cells.has_near(kept, corner)) continue;
    cells.add(corner);
    kept.push_back(corner);
  }
  return kept;
}

}  // namespace armlet
