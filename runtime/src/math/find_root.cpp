#include "armlet/math/find_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

using Status = RootSearch::Status;

struct Point {
  double x = 0.0;
  double f = 0.0;
};

// Chandrupatla's test: whether the three points are spread so that the parabola through them, x as
// a function of f, can be used. Returns its zero, as a fraction of the distance from a to b.
double next_part(const Point& a, const Point& b, const Point& c) {
  const double xi = (a.x - b.x) / (c.x - b.x);
  const double phi = (a.f - b.f) / (c.f - b.f);
  if (!(phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)) return 0.5;
  return a.f / (b.f - a.f) * c.f / (b.f - c.f) +
         (c.x - a.x) / (b.x - a.x) * a.f / (c.f - a.f) * b.f / (c.f - b.f);
}

}  // namespace

RootSearch find_root(const RealFunction& f, double lo, double hi) {
  check_finite("lo", lo);
  check_finite("hi", hi);
  RootSearch out;
  const auto evaluate = [&](double x, double& value) {
    ++out.evaluations;
    out.x = x;
    if (!f(x, value)) {
      out.status = Status::kStopped;
      return false;
    }
    out.value = value;
    if (!std::isfinite(value)) out.status = Status::kNotFinite;
    return std::isfinite(value);
  };
  if (!evaluate(lo, out.at_lo) || out.at_lo == 0.0) return out;
  if (!evaluate(hi, out.at_hi) || out.at_hi == 0.0) return out;
  if ((out.at_lo < 0.0) == (out.at_hi < 0.0)) {
    out.status = Status::kSameSign;
    return out;
  }
  // a and b enclose the root, a is the newest point; c is the one before.
  Point b{lo, out.at_lo};
  Point a{hi, out.at_hi};
  Point c = a;
  double part = 0.5;
  for (;;) {
    const Point& best = std::abs(a.f) < std::abs(b.f) ? a : b;
    const double limit =
        2.0 * std::numeric_limits<double>::epsilon() * std::abs(best.x) + 1e-30 * std::abs(hi - lo);
    const double smallest = limit / std::abs(b.x - a.x);
    if (smallest > 0.5 || best.f == 0.0) {
      out.x = best.x;
      out.value = best.f;
      const double ends = std::min(std::abs(out.at_lo), std::abs(out.at_hi));
      const bool is_inside = best.x != lo && best.x != hi;
      if (is_inside && std::abs(best.f) >= ends) out.status = Status::kJump;
      return out;
    }
    part = std::clamp(part, smallest, 1.0 - smallest);
    Point next{a.x + part * (b.x - a.x), 0.0};
    if (!evaluate(next.x, next.f)) return out;
    if ((next.f < 0.0) == (a.f < 0.0)) {
      c = a;
    } else {
      c = b;
      b = a;
    }
    a = next;
    part = next_part(a, b, c);
  }
}

}  // namespace armlet
