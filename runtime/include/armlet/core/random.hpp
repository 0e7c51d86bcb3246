#pragma once

#include <array>
#include <cstdint>

namespace armlet {

// Seeded generator with the same numbers on every machine: xoshiro256** (Blackman and Vigna, 2018),
// seeded by splitmix64. Always an argument, never global.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  // 64 random bits.
  std::uint64_t next();

  // Uniform in [0, 1): the upper 53 bits times 2^-53.
  double uniform();

  // Uniform in [low, high). Throws ArgumentError unless both are finite and low <= high.
  double uniform(double low, double high);

  // A whole number in [0, n), all equally likely. Throws ArgumentError if n is 0.
  std::uint64_t below(std::uint64_t n);

  // An independent generator for a part of the work. It depends on this one's seed and on the
  // stream number, not on how many numbers were drawn before.
  Random split(std::uint64_t stream) const;

 private:
  std::uint64_t seed_;
  std::array<std::uint64_t, 4> state_;
};

}  // namespace armlet
