#include "armlet/vision/blobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

// Sums over the pixels of a region, as integers: below 2^53 for the largest pictures.
struct Sums {
  std::int64_t first = 0;  // index of its first pixel
  std::int64_t area = 0;
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t xx = 0;
  std::int64_t xy = 0;
  std::int64_t yy = 0;
  std::array<std::int64_t, 3> color{};
  PixelBox box;
};

void add(Sums& to, const Sums& from) {
  to.first = std::min(to.first, from.first);
  to.area += from.area;
  to.x += from.x;
  to.y += from.y;
  to.xx += from.xx;
  to.xy += from.xy;
  to.yy += from.yy;
  for (std::size_t c = 0; c < 3; ++c) to.color[c] += from.color[c];
  to.box = {std::min(to.box.left, from.box.left), std::min(to.box.top, from.box.top),
            std::max(to.box.right, from.box.right), std::max(to.box.bottom, from.box.bottom)};
}

// Consecutive pixels of a row, left <= x < right, of one region of the list.
struct Run {
  int left;
  int right;
  int region;
};

Sums sums_of_run(const Image& picture, int y, int left, int right) {
  const std::int64_t n = right - left;
  const auto squares_below = [](std::int64_t k) { return (k - 1) * k * (2 * k - 1) / 6; };
  Sums sums;
  sums.first = std::int64_t{y} * picture.width() + left;
  sums.area = n;
  sums.x = n * (left + right - 1) / 2;
  sums.y = n * y;
  sums.xx = squares_below(right) - squares_below(left);
  sums.xy = sums.x * y;
  sums.yy = sums.y * y;
  const int channels = picture.channels();
  const std::uint8_t* pixel = picture.row(y) + std::ptrdiff_t{left} * channels;
  for (int x = left; x < right; ++x, pixel += channels)
    for (std::size_t c = 0; c < 3; ++c) sums.color[c] += pixel[channels == 3 ? c : 0];
  sums.box = {left, y, right, y + 1};
  return sums;
}

// Moments about the centre, px^2. They are first computed about a whole pixel, so that no digits
// are lost with large coordinates.
struct Spread {
  double xx;
  double xy;
  double yy;
};

Spread spread_of(const Sums& s) {
  const std::int64_t x0 = s.x / s.area;
  const std::int64_t y0 = s.y / s.area;
  const double n = static_cast<double>(s.area);
  const double dx = static_cast<double>(s.x - s.area * x0) / n;
  const double dy = static_cast<double>(s.y - s.area * y0) / n;
  const std::int64_t xx = s.xx - 2 * x0 * s.x + s.area * x0 * x0;
  const std::int64_t xy = s.xy - x0 * s.y - y0 * s.x + s.area * x0 * y0;
  const std::int64_t yy = s.yy - 2 * y0 * s.y + s.area * y0 * y0;
  return {static_cast<double>(xx) / n - dx * dx, static_cast<double>(xy) / n - dx * dy,
          static_cast<double>(yy) / n - dy * dy};
}

Blob blob_of(const Sums& sums) {
  const Spread m = spread_of(sums);
  const double n = static_cast<double>(sums.area);
  Blob blob;
  blob.x = static_cast<double>(sums.x) / n;
  blob.y = static_cast<double>(sums.y) / n;
  blob.area = static_cast<int>(sums.area);
  const double mean = 0.5 * (m.xx + m.yy);
  const double half = 0.5 * (m.xx - m.yy);
  const double radius = std::sqrt(half * half + m.xy * m.xy);
  // Rounding must not determine the axis.
  constexpr double kRound = 1e-12;
  if (radius > kRound * mean) blob.angle = 0.5 * det::atan2(m.xy, half);
  // Pixels are squares with a second moment of 1/12 of their own.
  blob.width = std::sqrt(12.0 * (mean + radius) + 1.0);
  blob.height = std::sqrt(std::max(12.0 * (mean - radius), 0.0) + 1.0);
  for (std::size_t c = 0; c < 3; ++c) blob.color[c] = static_cast<double>(sums.color[c]) / n;
  blob.box = sums.box;
  return blob;
}

// Processes the rows and joins runs that touch. The list has only regions that reach the last row,
// so that memory does not grow with the picture.
class Regions {
 public:
  Regions(const Image& mask, const Image& picture, const BlobOptions& options)
      : mask_(mask), picture_(picture), options_(options) {}

  std::vector<Sums> find() {
    for (int y = 0; y < mask_.height(); ++y) {
      checkpoint(16 * static_cast<std::uint64_t>(mask_.width()));
      add_runs(y);
      join_runs();
      close_row();
    }
    for (const Sums& region : regions_) finish(region);
    std::sort(finished_.begin(), finished_.end(),
              [](const Sums& a, const Sums& b) { return a.first < b.first; });
    return std::move(finished_);
  }

 private:
  // Adds the runs of a row, each as a region of its own after those of the row before.
  void add_runs(int y) {
    const std::uint8_t* row = mask_.row(y);
    runs_.clear();
    for (int x = 0; x < mask_.width(); ++x) {
      if (row[x] == 0) continue;
      const int left = x;
      while (x < mask_.width() && row[x] != 0) ++x;
      runs_.push_back({left, x, static_cast<int>(regions_.size())});
      regions_.push_back(sums_of_run(picture_, y, left, x));
    }
    parents_.resize(regions_.size());
    for (std::size_t i = 0; i < parents_.size(); ++i) parents_[i] = static_cast<int>(i);
  }

  void join_runs() {
    const int reach = options_.touching == Touching::kCorners ? 1 : 0;
    std::size_t first = 0;
    for (const Run& run : runs_) {
      while (first < above_.size() && above_[first].right + reach <= run.left) ++first;
      // The last run above that touches may touch the next run too.
      for (std::size_t i = first; i < above_.size() && above_[i].left < run.right + reach; ++i)
        join(above_[i].region, run.region);
    }
  }

  int root(int region) {
    while (parents_[static_cast<std::size_t>(region)] != region) {
      int& parent = parents_[static_cast<std::size_t>(region)];
      parent = parents_[static_cast<std::size_t>(parent)];
      region = parent;
    }
    return region;
  }

  void join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    add(regions_[static_cast<std::size_t>(std::min(a, b))],
        regions_[static_cast<std::size_t>(std::max(a, b))]);
  }

  // Keeps the regions that have a run in this row and finishes the others.
  void close_row() {
    indices_.assign(regions_.size(), -1);
    kept_.clear();
    for (Run& run : runs_) {
      const auto region = static_cast<std::size_t>(root(run.region));
      if (indices_[region] < 0) {
        indices_[region] = static_cast<int>(kept_.size());
        kept_.push_back(regions_[region]);
      }
      run.region = indices_[region];
    }
    for (std::size_t i = 0; i < regions_.size(); ++i)
      if (parents_[i] == static_cast<int>(i) && indices_[i] < 0) finish(regions_[i]);
    regions_.swap(kept_);
    above_.swap(runs_);
  }

  void finish(const Sums& region) {
    if (region.area >= options_.min_area) finished_.push_back(region);
  }

  const Image& mask_;
  const Image& picture_;
  BlobOptions options_;
  std::vector<Run> runs_;   // of this row
  std::vector<Run> above_;  // of the row before
  std::vector<Sums> regions_;
  std::vector<Sums> kept_;
  std::vector<int> parents_;
  std::vector<int> indices_;
  std::vector<Sums> finished_;
};

}  // namespace

std::vector<Blob> find_blobs(const Image& mask, const Image& picture, const BlobOptions& options) {
  check_grey("find_blobs", mask);
  check_8_bit("blobs", picture);
  check_picture_parameter("blobs", "minArea", options.min_area);
  if (mask.width() != picture.width() || mask.height() != picture.height()) {
    throw ArgumentError(
        fmt::format("`find_blobs` got a mask of {} x {} pixels and a picture of {} x {}; expected "
                    "the same size.",
                    mask.width(), mask.height(), picture.width(), picture.height()));
  }
  std::vector<Blob> blobs;
  for (const Sums& sums : Regions(mask, picture, options).find()) blobs.push_back(blob_of(sums));
  return blobs;
}

Image color_mask(const Image& picture, std::array<std::uint8_t, 3> color, int tolerance) {
  check_8_bit("blobs", picture);
  check_picture_parameter("blobs", "tolerance", tolerance);
  Image mask(picture.width(), picture.height(), PixelKind::kGrey);
  const int channels = picture.channels();
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, pixel += channels) {
      bool is_alike = true;
      for (std::size_t c = 0; c < 3; ++c)
        is_alike = is_alike && std::abs(pixel[channels == 3 ? c : 0] - color[c]) <= tolerance;
      mask.row(y)[x] = is_alike ? 255 : 0;
    }
  }
  return mask;
}

}  // namespace armlet
