#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace armlet {

// The vectors of an OdeIntegrator: slopes, a trial state, and for the interpolation polynomial its
// coefficients, the state at the end of its step and the state that was evaluated last.
inline constexpr int kTrial = 7;
inline constexpr int kPolynomial = 8;
inline constexpr int kAhead = 13;
inline constexpr int kRead = 14;
inline constexpr int kOdeVectors = 15;

// The index of the first element that is not finite; -1: none.
inline int first_not_finite(std::span<const double> y) {
  const auto bad = std::ranges::find_if(y, [](double x) { return !std::isfinite(x); });
  return bad == y.end() ? -1 : static_cast<int>(bad - y.begin());
}

}  // namespace armlet
