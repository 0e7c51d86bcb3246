#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace armlet {

// Cube root of a number >= 0 with the same bits on every machine, to within one or two units in the
// last place.
//
// source  the iteration of E. Halley, Philosophical Transactions 18, 1694.
inline double cube_root(double x) {
  if (!(x > 0.0) || std::isinf(x)) return x;
  // Dividing the exponent by three gives a guess within 6 %; each of the three steps of Halley's
  // method triples the number of correct digits.
  double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2A9F7893782DA1CEull);
  for (int k = 0; k < 3; ++k) {
    const double cube = y * y * y;
    y -= y * (cube - x) / (2.0 * cube + x);
  }
  return y;
}

}  // namespace armlet
