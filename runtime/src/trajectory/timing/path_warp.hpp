#pragma once

#include <algorithm>

#include "trajectory/cube_root.hpp"

namespace armlet {

// A parameter u of a path such that s grows like u^3 at both ends, so a motion that begins with a
// jerk has a nonzero speed in u there; in between s grows like u. Twice continuously
// differentiable.
class PathWarp {
 public:
  // start, end  lengths of the ends in u; half as long in s. Both above 0, or 0 for a path that
  //             already begins or ends like t^3; their sum at most twice the length.
  PathWarp(double length, double start, double end)
      : length_(length), start_(start), end_(end), whole_(length + 0.5 * (start + end)) {}

  // s and its derivatives by u.
  struct Along {
    double s, first, second, third;
  };

  [[nodiscard]] double whole() const { return whole_; }
  [[nodiscard]] double start() const { return start_; }
  [[nodiscard]] double end() const { return end_; }

  [[nodiscard]] Along at(double u) const {
    if (u < start_) return ramp(u, start_);
    if (u > whole_ - end_) {
      const Along back = ramp(whole_ - u, end_);
      return {length_ - back.s, back.first, -back.second, back.third};
    }
    return {u - 0.5 * start_, 1.0, 0.0, 0.0};
  }

  // The u of a position.
  [[nodiscard]] double inverse(double s) const {
    if (s <= 0.0) return 0.0;
    if (s >= length_) return whole_;
    if (s <= 0.5 * start_) return ramp_inverse(s, start_);
    if (s >= length_ - 0.5 * end_) return whole_ - ramp_inverse(length_ - s, end_);
    return s + 0.5 * start_;
  }

 private:
  // w (x^3 - x^4 / 2) with x = u / w.
  static Along ramp(double u, double w) {
    const double x = std::max(u, 0.0) / w;
    return {w * x * x * x * (1.0 - 0.5 * x), x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / w,
            6.0 * (1.0 - 2.0 * x) / (w * w)};
  }

  // Newton's method from the right of the zero of a convex function.
  static double ramp_inverse(double s, double w) {
    const double part = std::max(s, 0.0) / w;
    double x = std::min(cube_root(2.0 * part), 1.0);
    for (int k = 0; k < 12 && x > 0.0; ++k)
      x -= (x * x * x * (1.0 - 0.5 * x) - part) / (x * x * (3.0 - 2.0 * x));
    return w * x;
  }

  double length_, start_, end_, whole_;
};

}  // namespace armlet
