#include "armlet/vision/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

// The sums of the normal equations, with positions relative to the centre of the window.
struct NormalEquations {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double right_x = 0.0;
  double right_y = 0.0;
};

class Window {
 public:
  Window(const Image& grey, int half)
      : grey_(grey),
        half_(half),
        side_(2 * half + 3),  // gradients need one pixel more on each side
        values_(static_cast<std::size_t>(side_ * side_)) {
    for (int d = -half; d <= half; ++d) {
      const double share = static_cast<double>(d) / half;
      bell_.push_back(det::exp(-share * share));
    }
  }

  [[nodiscard]] NormalEquations equations_at(double x, double y) {
    sample(x, y);
    NormalEquations sums;
    for (int dy = -half_; dy <= half_; ++dy) {
      for (int dx = -half_; dx <= half_; ++dx) {
        const double* value = values_.data() + (dy + half_ + 1) * side_ + dx + half_ + 1;
        const double gx = value[1] - value[-1];
        const double gy = value[side_] - value[-side_];
        const double weight = bell(dx) * bell(dy);
        const double xx = weight * gx * gx;
        const double xy = weight * gx * gy;
        const double yy = weight * gy * gy;
        sums.xx += xx;
        sums.xy += xy;
        sums.yy += yy;
        sums.right_x += xx * dx + xy * dy;
        sums.right_y += xy * dx + yy * dy;
      }
    }
    return sums;
  }

 private:
  [[nodiscard]] double bell(int d) const { return bell_[static_cast<std::size_t>(d + half_)]; }

  // Brightness around a point between pixels; all pixels of the window have the same fractional
  // offsets.
  void sample(double x, double y) {
    const double left = std::floor(x);
    const double top = std::floor(y);
    const double a = x - left;
    const double b = y - top;
    double* out = values_.data();
    for (int dy = -half_ - 1; dy <= half_ + 1; ++dy) {
      const std::uint8_t* above = row(static_cast<int>(top) + dy);
      const std::uint8_t* below = row(static_cast<int>(top) + dy + 1);
      for (int dx = -half_ - 1; dx <= half_ + 1; ++dx) {
        const int l = column(static_cast<int>(left) + dx);
        const int r = column(static_cast<int>(left) + dx + 1);
        const double upper = (1.0 - a) * above[l] + a * above[r];
        const double lower = (1.0 - a) * below[l] + a * below[r];
        *out++ = (1.0 - b) * upper + b * lower;
      }
    }
  }

  [[nodiscard]] const std::uint8_t* row(int y) const {
    return grey_.row(std::clamp(y, 0, grey_.height() - 1));
  }
  [[nodiscard]] int column(int x) const { return std::clamp(x, 0, grey_.width() - 1); }

  const Image& grey_;
  int half_;
  int side_;
  std::vector<double> bell_;
  std::vector<double> values_;
};

bool is_inside(const Image& image, double x, double y) {
  return x >= 0.0 && y >= 0.0 && x <= image.width() - 1 && y <= image.height() - 1;
}

RefinedCorner refined(const Image& grey, Window& window, double x0, double y0,
                      const RefineOptions& options) {
  RefinedCorner corner{x0, y0, RefineEnd::kIterations};
  const auto side = static_cast<std::uint64_t>(2 * options.window + 1);
  for (int i = 0; i < options.iterations; ++i) {
    checkpoint(16 * side * side);
    const NormalEquations sums = window.equations_at(corner.x, corner.y);
    const double determinant = sums.xx * sums.yy - sums.xy * sums.xy;
    const double trace = sums.xx + sums.yy;
    // If all gradients are parallel the determinant is 0 within rounding.
    constexpr double kSingular = 1e-12;
    if (determinant <= kSingular * trace * trace) return {corner.x, corner.y, RefineEnd::kNoCorner};
    const double step_x = (sums.yy * sums.right_x - sums.xy * sums.right_y) / determinant;
    const double step_y = (sums.xx * sums.right_y - sums.xy * sums.right_x) / determinant;
    corner.x += step_x;
    corner.y += step_y;
    if (std::abs(corner.x - x0) > options.window || std::abs(corner.y - y0) > options.window ||
        !is_inside(grey, corner.x, corner.y))
      return {x0, y0, RefineEnd::kLeft};
    if (step_x * step_x + step_y * step_y <= options.precision * options.precision) {
      corner.end = RefineEnd::kConverged;
      return corner;
    }
  }
  return corner;
}

}  // namespace

std::vector<RefinedCorner> refine_corners(const Image& grey, const PlanePoints& starts,
                                          const RefineOptions& options) {
  check_grey("refine_corners", grey);
  check_picture_parameter("refineCorners", "window", options.window);
  check_picture_parameter("refineCorners", "iterations", options.iterations);
  check_picture_parameter("refineCorners", "precision", options.precision);
  Window window(grey, options.window);
  std::vector<RefinedCorner> corners;
  for (Eigen::Index i = 0; i < starts.rows(); ++i) {
    const double x = starts(i, 0);
    const double y = starts(i, 1);
    if (!is_inside(grey, x, y)) {
      throw ArgumentError(
          fmt::format("Corner {} at ({}, {}) px is outside the picture of {} x {} pixels.", i + 1,
                      x, y, grey.width(), grey.height()));
    }
    corners.push_back(refined(grey, window, x, y, options));
  }
  return corners;
}

}  // namespace armlet
