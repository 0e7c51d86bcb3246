#pragma once
// The samples of a picture that a triangle covers, in integers.

#include <algorithm>
#include <array>
#include <cstdint>

namespace armlet::raster {

inline constexpr int kOne = 256;  // steps of a pixel: 24.8 fixed point

// Corners beyond these pixels are clipped first, so that products fit into 64 bits.
inline constexpr double kGuardLow = -12288.0;
inline constexpr double kGuardHigh = 20480.0;

// A coordinate in pixels within the guard, rounded to the nearest step.
inline std::int32_t to_fixed(double pixels) {
  constexpr double kShift = 16384.0;  // makes it positive, so that truncating rounds down
  const double limited = std::clamp(pixels, kGuardLow, kGuardHigh);
  return static_cast<std::int32_t>((limited + kShift) * kOne + 0.5) -
         static_cast<std::int32_t>(kShift) * kOne;
}

// Columns and rows of samples: sample (i, k) lies at (x + i step, y + k step), in steps of a pixel.
struct SampleGrid {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t step = kOne;
  int columns = 0;
  int rows = 0;

  // Samples of a picture whose upper left pixel is (left, top): in its pixels' centres, or 2 x 2.
  static SampleGrid of_picture(int left, int top, int width, int height, int samples) {
    const int n = samples == 4 ? 2 : 1;
    const std::int32_t inset = n == 2 ? kOne / 4 : 0;
    return {left * kOne - inset, top * kOne - inset, kOne / n, n * width, n * height};
  }
  [[nodiscard]] double u(int column) const { return (x + column * step) * (1.0 / kOne); }
  [[nodiscard]] double v(int row) const { return (y + row * step) * (1.0 / kOne); }
};

struct FixedTriangle {
  std::array<std::int32_t, 3> x;
  std::array<std::int32_t, 3> y;

  // Twice the area, positive if the corners run clockwise in the picture (y is down).
  [[nodiscard]] std::int64_t doubled_area() const {
    return std::int64_t{x[1] - x[0]} * (y[2] - y[0]) - std::int64_t{x[2] - x[0]} * (y[1] - y[0]);
  }
};

inline std::int64_t floor_quotient(std::int64_t a, std::int64_t b) {  // b > 0
  const std::int64_t q = a / b;
  return q - (a % b < 0 ? 1 : 0);
}

// The first row of samples at or below y; also used for columns.
inline int first_at(std::int32_t y, std::int32_t origin, std::int32_t step) {
  return static_cast<int>(floor_quotient(std::int64_t{y} - origin + step - 1, step));
}

// Follows an edge row by row with the first column at or right of it: exactly, since the remainder
// of the division is updated with each row.
class EdgeWalk {
 public:
  // From (xa, ya) down to (xb, yb), ya < yb, beginning at a row.
  EdgeWalk(std::int32_t xa, std::int32_t ya, std::int32_t xb, std::int32_t yb,
           const SampleGrid& grid, int row) {
    const std::int64_t dx = xb - xa, dy = yb - ya;
    whole_ = dy * grid.step;
    const std::int64_t y = grid.y + std::int64_t{row} * grid.step;
    const std::int64_t numerator = (std::int64_t{xa} - grid.x) * dy + dx * (y - ya) + whole_ - 1;
    column_ = floor_quotient(numerator, whole_);
    rest_ = numerator - column_ * whole_;
    step_ = floor_quotient(dx, dy);
    step_rest_ = (dx - step_ * dy) * grid.step;
  }
  [[nodiscard]] std::int64_t column() const { return column_; }
  void next() {
    column_ += step_;
    rest_ += step_rest_;
    if (rest_ >= whole_) {
      rest_ -= whole_;
      ++column_;
    }
  }

 private:
  std::int64_t column_, rest_, step_, step_rest_, whole_;
};

// Calls span(row, from, to) for the samples of a triangle, from <= column < to, in the rows from
// `begin` to `end` - 1 of the grid. A sample on an edge belongs to the triangle whose left or upper
// edge that is, so that triangles side by side share no sample and leave none out.
template <class Span>
void cover(const FixedTriangle& t, const SampleGrid& grid, int begin, int end, Span&& span) {
  const std::int64_t area = t.doubled_area();
  if (area == 0) return;
  std::array<std::size_t, 3> order{0, 1, 2};
  if (t.y[order[1]] < t.y[order[0]]) std::swap(order[0], order[1]);
  if (t.y[order[2]] < t.y[order[1]]) std::swap(order[1], order[2]);
  if (t.y[order[1]] < t.y[order[0]]) std::swap(order[0], order[1]);
  const auto [a, b, c] = order;
  const int top = std::max(begin, first_at(t.y[a], grid.y, grid.step));
  const int middle = first_at(t.y[b], grid.y, grid.step);
  const int bottom = std::min(end, first_at(t.y[c], grid.y, grid.step));
  if (top >= bottom) return;
  // Twice the area of (a, b, c) in their order from above: positive if b lies right of a - c.
  const bool even = (a == 0 && b == 1) || (a == 1 && b == 2) || (a == 2 && b == 0);
  const bool right = even == (area > 0);
  EdgeWalk across(t.x[a], t.y[a], t.x[c], t.y[c], grid, top);
  const auto walk = [&](EdgeWalk side, int from, int to) {
    for (int row = from; row < to; ++row) {
      const std::int64_t left = right ? across.column() : side.column();
      const std::int64_t stop = right ? side.column() : across.column();
      const int first = static_cast<int>(std::max<std::int64_t>(left, 0));
      const int last = static_cast<int>(std::min<std::int64_t>(stop, grid.columns));
      if (first < last) span(row, first, last);
      across.next();
      side.next();
    }
  };
  const int turn = std::clamp(middle, top, bottom);
  if (top < turn) walk(EdgeWalk(t.x[a], t.y[a], t.x[b], t.y[b], grid, top), top, turn);
  if (turn < bottom) walk(EdgeWalk(t.x[b], t.y[b], t.x[c], t.y[c], grid, turn), turn, bottom);
}

}  // namespace armlet::raster
