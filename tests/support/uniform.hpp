#pragma once

#include <random>

namespace armlet {

// Uniform between lower and upper, for tests that draw from a generator of the standard library.
inline double uniform(std::mt19937_64& generator, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

}  // namespace armlet
