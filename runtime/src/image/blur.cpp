#include "armlet/image/blur.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

// Copies a row with its first and last pixel repeated `radius` times.
void extend_row(const Image& image, int y, int radius, std::vector<std::uint8_t>& out) {
  const std::uint8_t* row = image.row(y);
  const int channels = image.channels();
  const int last = (image.width() - 1) * channels;
  std::uint8_t* to = out.data();
  for (int i = 0; i < radius; ++i) to = std::copy_n(row, channels, to);
  to = std::copy_n(row, last + channels, to);
  for (int i = 0; i < radius; ++i) to = std::copy_n(row + last, channels, to);
}

int nearest_row(const Image& image, int y) { return std::clamp(y, 0, image.height() - 1); }

// Gaussian weights for the distances 0 ... radius; the sum of all is 65536.
std::vector<std::uint32_t> weights_of(double sigma) {
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> bell;
  for (int d = 0; d <= radius; ++d)
    bell.push_back(det::exp(-static_cast<double>(d) * d / (2.0 * sigma * sigma)));
  const double sum = 2.0 * std::accumulate(bell.begin() + 1, bell.end(), 0.0) + bell[0];
  std::vector<std::uint32_t> weights;
  for (const double value : bell)
    weights.push_back(static_cast<std::uint32_t>(std::floor(65536.0 * value / sum + 0.5)));
  const std::uint32_t sides =
      2 * std::accumulate(weights.begin() + 1, weights.end(), std::uint32_t{0});
  weights[0] = 65536 - sides;  // so that a uniform picture is unchanged
  return weights;
}

// Sums of rows and columns, row by row; stores as many rows as the filter is wide.
class GaussianBlur {
 public:
  GaussianBlur(const Image& image, double sigma)
      : image_(image),
        weights_(weights_of(sigma)),
        radius_(static_cast<int>(weights_.size()) - 1),
        values_(static_cast<std::size_t>(image.width() * image.channels())),
        extended_(values_ + static_cast<std::size_t>(2 * radius_ * image.channels())),
        sums_(values_),
        ring_(static_cast<std::size_t>(2 * radius_ + 1), std::vector<std::uint16_t>(values_)) {}

  Image run() {
    Image result(image_.width(), image_.height(), image_.kind());
    for (int y = -radius_; y < radius_; ++y) blur_row(y);
    for (int y = 0; y < image_.height(); ++y) {
      blur_row(y + radius_);
      blur_columns(y, result.row(y));
    }
    return result;
  }

 private:
  std::vector<std::uint16_t>& ring_row(int y) {
    const int rows = 2 * radius_ + 1;
    return ring_[static_cast<std::size_t>((y + rows) % rows)];
  }

  // Filters row y, or the nearest row of the picture, in 2^-8 grey levels.
  void blur_row(int y) {
    checkpoint(values_ * weights_.size());
    extend_row(image_, nearest_row(image_, y), radius_, extended_);
    std::fill(sums_.begin(), sums_.end(), 128U);
    for (int d = -radius_; d <= radius_; ++d) {
      const std::uint32_t weight = weights_[static_cast<std::size_t>(std::abs(d))];
      const std::uint8_t* from = extended_.data() + (d + radius_) * image_.channels();
      for (std::size_t i = 0; i < values_; ++i) sums_[i] += weight * from[i];
    }
    std::vector<std::uint16_t>& out = ring_row(y);
    for (std::size_t i = 0; i < values_; ++i) out[i] = static_cast<std::uint16_t>(sums_[i] >> 8);
  }

  void blur_columns(int y, std::uint8_t* out) {
    checkpoint(values_ * weights_.size());
    std::fill(sums_.begin(), sums_.end(), 1U << 23);
    for (int d = -radius_; d <= radius_; ++d) {
      const std::uint32_t weight = weights_[static_cast<std::size_t>(std::abs(d))];
      const std::uint16_t* from = ring_row(y + d).data();
      // At most 255 * 2^24 + 2^23, which does not overflow.
      for (std::size_t i = 0; i < values_; ++i) sums_[i] += weight * from[i];
    }
    for (std::size_t i = 0; i < values_; ++i) out[i] = static_cast<std::uint8_t>(sums_[i] >> 24);
  }

  const Image& image_;
  std::vector<std::uint32_t> weights_;
  int radius_;
  std::size_t values_;  // of a row
  std::vector<std::uint8_t> extended_;
  std::vector<std::uint32_t> sums_;
  std::vector<std::vector<std::uint16_t>> ring_;
};

}  // namespace

Image box_blurred(const Image& image, int radius) {
  check_8_bit("boxBlur", image);
  check_picture_parameter("boxBlur", "radius", radius);
  if (radius == 0) return image;
  const std::size_t channels = static_cast<std::size_t>(image.channels());
  const std::size_t side = static_cast<std::size_t>(2 * radius + 1);
  const std::uint32_t area = static_cast<std::uint32_t>(side * side);
  const std::size_t width =
      (static_cast<std::size_t>(image.width()) + side - 1) * channels;  // extended
  std::vector<std::uint8_t> row(width);
  std::vector<std::uint32_t> columns(width);
  const auto add_row = [&](int y) {
    checkpoint(8 * width);
    extend_row(image, nearest_row(image, y), radius, row);
    for (std::size_t i = 0; i < width; ++i) columns[i] += row[i];
  };
  const auto take_row = [&](int y) {
    extend_row(image, nearest_row(image, y), radius, row);
    for (std::size_t i = 0; i < width; ++i) columns[i] -= row[i];
  };
  Image result(image.width(), image.height(), image.kind());
  for (int y = -radius; y < radius; ++y) add_row(y);
  for (int y = 0; y < image.height(); ++y) {
    add_row(y + radius);
    std::uint8_t* out = result.row(y);
    for (std::size_t c = 0; c < channels; ++c) {
      std::uint32_t sum = area / 2;
      for (std::size_t i = 0; i + 1 < side; ++i) sum += columns[i * channels + c];
      for (std::size_t x = 0; x < static_cast<std::size_t>(image.width()); ++x) {
        sum += columns[(x + side - 1) * channels + c];
        out[x * channels + c] = static_cast<std::uint8_t>(sum / area);
        sum -= columns[x * channels + c];
      }
    }
    take_row(y - radius);
  }
  return result;
}

Image gaussian_blurred(const Image& image, double sigma) {
  check_8_bit("blur", image);
  check_picture_parameter("blur", "sigma", sigma);
  // Below this every weight except the central one rounds to 0.
  constexpr double kLeastSigma = 0.2;
  return sigma < kLeastSigma ? image : GaussianBlur(image, sigma).run();
}

}  // namespace armlet
