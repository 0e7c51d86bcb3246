#include "armlet/image/noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

constexpr int kEntries = 1 << 15;

// Quantiles of the upper half of the normal distribution, at the probabilities 1/2 + (i + 1/2) /
// 65536: computed by integrating dz/dp from entry to entry.
std::vector<float> upper_quantiles() {
  constexpr double kRoot = 2.506628274631000502;                              // sqrt(2 pi)
  const auto slope = [](double z) { return kRoot * det::exp(0.5 * z * z); };  // dz / dp
  std::vector<float> quantiles;
  quantiles.reserve(kEntries);
  double z = 0.0;
  for (int i = 0; i < kEntries; ++i) {
    // The slope grows without bound towards the end; eight Runge-Kutta steps give seven digits.
    constexpr int kSteps = 8;
    const double h = (i == 0 ? 0.5 : 1.0) / (2.0 * kEntries * kSteps);
    for (int step = 0; step < kSteps; ++step) {
      const double k1 = slope(z);
      const double k2 = slope(z + 0.5 * h * k1);
      const double k3 = slope(z + 0.5 * h * k2);
      const double k4 = slope(z + h * k3);
      z += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    quantiles.push_back(static_cast<float>(z));
  }
  return quantiles;
}

}  // namespace

void add_noise(Image& image, double sigma, Random& random) {
  check_8_bit("noise", image);
  check_picture_parameter("noise", "sigma", sigma);
  if (sigma == 0.0) return;
  static const std::vector<float> kQuantiles = upper_quantiles();
  const auto deviation = static_cast<float>(sigma);
  const std::size_t count = image.bytes().size();
  std::uint8_t* pixels = image.row(0);
  constexpr std::size_t kBlock = 1 << 16;  // values
  for (std::size_t first = 0; first < count; first += 4) {
    if (first % kBlock == 0) checkpoint(8 * kBlock);
    std::uint64_t bits = random.next();
    for (std::size_t i = first; i < std::min(first + 4, count); ++i, bits >>= 16) {
      const float z = deviation * kQuantiles[bits & (kEntries - 1)];
      const float value = static_cast<float>(pixels[i]) + ((bits & kEntries) != 0 ? -z : z);
      pixels[i] = static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F) + 0.5F);
    }
  }
}

}  // namespace armlet
