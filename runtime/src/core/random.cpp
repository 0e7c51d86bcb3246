#include "armlet/core/random.hpp"

#include <fmt/format.h>

#include <bit>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

// One step of splitmix64 (Steele, Lea and Flood, 2014).
std::uint64_t splitmix64(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed) : seed_(seed), state_{} {
  for (std::uint64_t& word : state_) word = splitmix64(seed);
}

std::uint64_t Random::next() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

double Random::uniform(double low, double high) {
  check_finite("low", low);
  check_finite("high", high);
  if (low > high) {
    throw ArgumentError(
        fmt::format("The range {} to {} is empty; low must not exceed high.", low, high));
  }
  const double value = low + (high - low) * uniform();
  // Rounding may give the upper end, which the range excludes.
  return value < high ? value : low;
}

std::uint64_t Random::below(std::uint64_t n) {
  if (n == 0) throw ArgumentError("A whole number below 0 was asked for; n must be at least 1.");
  // Values from the incomplete last block would make small results more likely.
  const std::uint64_t unfair = (0 - n) % n;
  std::uint64_t value = next();
  while (value < unfair) value = next();
  return value % n;
}

Random Random::split(std::uint64_t stream) const {
  std::uint64_t state = seed_;
  const std::uint64_t mixed = splitmix64(state);
  state = mixed ^ (stream * 0xd1342543de82ef95u);
  return Random(splitmix64(state));
}

}  // namespace armlet
