#include "armlet/vision/susan.hpp"

#include <algorithm>
#include <cstdlib>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/det_math.hpp"
#include "vision/susan_rows.hpp"

namespace armlet {
namespace {

constexpr int kBorder = 5;  // px
// half of the square in which only one corner is kept, px
constexpr int kSuppression = 3;
constexpr int kRing = 2 * kSuppression + 1;   // rows
constexpr int kHalfWidths[4] = {3, 3, 2, 1};  // of the mask, by distance from its middle row
constexpr int kContiguous = 290;              // of 300

SusanTable table_of(int threshold) {
  SusanTable table{};
  int first_unlike = 256;
  for (int d = 0; d < 256; ++d) {
    float u = static_cast<float>(d) / static_cast<float>(threshold);
    u *= u;
    u = u * u * u;
    // Rounding to float makes values just below 100 equal to 100, as in the detector of 1997.
    const float c = static_cast<float>(100.0 * det::exp(-static_cast<double>(u)));
    table.similarity[d] = static_cast<std::uint8_t>(c);
    if (table.similarity[d] == 100) table.last_alike = d;
    if (table.similarity[d] == 0) first_unlike = std::min(first_unlike, d);
  }
  table.steps = first_unlike - table.last_alike;
  return table;
}

// The pixels around one pixel, with its similarities.
class Mask {
 public:
  Mask(const Image& grey, const SusanTable& table, int x, int y)
      : nucleus_(grey.row(y) + x), stride_(grey.width()), table_(&table) {}

  [[nodiscard]] int similarity(int dx, int dy) const {
    return table_->similarity[std::abs(int{nucleus_[dy * stride_ + dx]} - int{*nucleus_})];
  }

  // Sums of the offsets of similar pixels.
  struct Sums {
    int x = 0;
    int y = 0;
  };
  [[nodiscard]] Sums sums() const {
    Sums sums;
    for (int dy = -3; dy <= 3; ++dy) {
      const int half = kHalfWidths[std::abs(dy)];
      for (int dx = -half; dx <= half; ++dx) {
        const int c = similarity(dx, dy);
        sums.x += dx * c;
        sums.y += dy * c;
      }
    }
    return sums;
  }

  // Whether the three pixels from the nucleus towards the centroid are similar.
  [[nodiscard]] bool is_contiguous(const Sums& sums) const {
    const int x = std::abs(sums.x);
    const int y = std::abs(sums.y);
    int total = 0;
    for (int k = 1; k <= 3; ++k) {
      const int along_x = y < x ? k : rounded_quotient(k * x, y);
      const int along_y = y < x ? rounded_quotient(k * y, x) : k;
      total += similarity(sums.x < 0 ? -along_x : along_x, sums.y < 0 ? -along_y : along_y);
    }
    return total > kContiguous;
  }

 private:
  // The nearest integer, of two equally near ones the larger.
  static int rounded_quotient(int a, int b) { return (2 * a + b) / (2 * b); }

  const std::uint8_t* nucleus_;
  std::ptrdiff_t stride_;
  const SusanTable* table_;
};

int response_at(const Image& grey, const SusanTable& table, int x, int y, int n) {
  const Mask mask(grey, table, x, y);
  const Mask::Sums sums = mask.sums();
  const bool is_off_centre = sums.x * sums.x + sums.y * sums.y > n * n / 2;
  return is_off_centre && mask.is_contiguous(sums) ? kSusanLimit - n : 0;
}

// The responses of the last seven rows, which are compared with one another.
class Responses {
 public:
  explicit Responses(int width) : width_(width), values_(static_cast<std::size_t>(width) * kRing) {}

  std::uint16_t* row(int y) { return values_.data() + (y % kRing) * width_; }
  void clear(int y) { std::fill_n(row(y), width_, std::uint16_t{0}); }

  // Whether no response around it is larger and no earlier one in the order of rows is equal.
  bool is_largest(int x, int y) {
    const int own = row(y)[x];
    for (int dy = -kSuppression; dy <= kSuppression; ++dy) {
      const std::uint16_t* other = row(y + dy) + x;
      for (int dx = -kSuppression; dx <= kSuppression; ++dx) {
        const bool is_before = dy < 0 || (dy == 0 && dx < 0);
        if (is_before ? own <= other[dx] : own < other[dx]) return false;
      }
    }
    return true;
  }

 private:
  std::ptrdiff_t width_;
  std::vector<std::uint16_t> values_;
};

}  // namespace

void susan_row_scalar(const std::uint8_t* nucleus, std::ptrdiff_t stride, int count,
                      const SusanTable& table, std::uint16_t* areas) {
  constexpr int kOrder[7] = {0, -1, 1, -2, 2, -3, 3};  // wide rows first: they end the sum early
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* centre = nucleus + i;
    int area = 0;
    for (const int dy : kOrder) {
      const int half = kHalfWidths[dy < 0 ? -dy : dy];
      const std::uint8_t* row = centre + dy * stride;
      for (int dx = -half; dx <= half; ++dx)
        area += table.similarity[std::abs(int{row[dx]} - int{*centre})];
      if (area >= kSusanLimit) break;
    }
    areas[i] = static_cast<std::uint16_t>(area);
  }
}

std::vector<SusanCorner> susan_corners(const Image& grey, const SusanOptions& options) {
  check_grey("susan_corners", grey);
  check_picture_parameter("corners", "threshold", options.threshold);
  check_supported(options.set);
  const SusanTable table = table_of(options.threshold);
  SusanRow* const compute_row =
      options.set >= InstructionSet::kAvx2 ? susan_row_avx2 : susan_row_scalar;

  std::vector<SusanCorner> corners;
  constexpr std::uint64_t kOfPixel = 40;  // operations
  const int width = grey.width() - 2 * kBorder;
  const int last = grey.height() - kBorder - 1;  // row
  if (width < 1) return corners;
  std::vector<std::uint16_t> areas(static_cast<std::size_t>(width));
  Responses responses(grey.width());
  for (int y = kBorder; y <= last + kSuppression; ++y) {
    checkpoint(kOfPixel * static_cast<std::uint64_t>(width));
    responses.clear(y);
    if (y <= last) {
      compute_row(grey.row(y) + kBorder, grey.width(), width, table, areas.data());
      for (int i = 0; i < width; ++i) {
        const int n = areas[static_cast<std::size_t>(i)];
        if (n >= kSusanLimit) continue;
        const int x = kBorder + i;
        responses.row(y)[x] = static_cast<std::uint16_t>(response_at(grey, table, x, y, n));
      }
    }
    const int done = y - kSuppression;
    if (done < kBorder) continue;
    for (int x = kBorder; x < kBorder + width; ++x) {
      const int response = responses.row(done)[x];
      if (response == 0 || !responses.is_largest(x, done)) continue;
      const Mask::Sums sums = Mask(grey, table, x, done).sums();
      corners.push_back({x, done, response, sums.x, sums.y, grey.row(done)[x]});
    }
  }
  return corners;
}

}  // namespace armlet
