#pragma once
// Root of a function of one number.

#include <cstdint>
#include <functional>

namespace armlet {

// Writes f(x) to `value`. Returns false to end the search.
using RealFunction = std::function<bool(double x, double& value)>;

struct RootSearch {
  enum class Status : std::uint8_t {
    kFound,
    kStopped,    // the function returned false
    kSameSign,   // f has the same sign at both ends
    kNotFinite,  // f(x) is infinite or undefined at x
    kJump,       // f changes its sign at x without coming near zero: a jump or a pole
  };
  Status status = Status::kFound;
  double x = 0.0;      // the root, or the x of a failure
  double value = 0.0;  // f(x)
  double at_lo = 0.0;  // f at the lower and the upper end
  double at_hi = 0.0;
  int evaluations = 0;
};

// A zero of f between lo and hi, where f has different signs (or is zero at one of them), to within
// 4 eps |x| + 1e-30 |hi - lo|.
//
// Inverse quadratic interpolation where it converges, bisection elsewhere.
//
// lo, hi  finite, in any order.
// throws  ArgumentError if an end is not finite.
// source  T. R. Chandrupatla, Advances in Engineering Software 28(3), 1997.
[[nodiscard]] RootSearch find_root(const RealFunction& f, double lo, double hi);

}  // namespace armlet
