#pragma once

#include <cmath>

namespace armlet {

// A zero of f between a and b, f(a) = fa and f(b) = fb of different signs. Ends when |f| <= small
// or when the bracket is as narrow as rounding allows.
//
// source  T. R. Chandrupatla, Advances in Engineering Software 28(3), 1997.
template <class Function>
double zero_between(const Function& f, double a, double fa, double b, double fb, double small) {
  if (std::abs(fa) <= small) return a;
  if (std::abs(fb) <= small) return b;
  // The first guess is that of the secant method.
  double t = fa / (fa - fb);
  for (int k = 0; k < 200; ++k) {
    const double x = a + t * (b - a);
    const double fx = f(x);
    const bool same = (fx < 0.0) == (fa < 0.0);
    const double c = same ? a : b, fc = same ? fa : fb;
    if (!same) {
      b = a;
      fb = fa;
    }
    a = x;
    fa = fx;
    // a is the newest point, b the other end of the bracket, c the end that was replaced last.
    const double best = std::abs(fa) < std::abs(fb) ? a : b;
    if (std::abs(fx) <= small) return x;
    const double tolerance = 2e-16 * std::abs(best) + 1e-300;
    const double least = tolerance / std::abs(b - a);
    if (least > 0.5) return best;
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    } else {
      t = 0.5;
    }
    t = t < least ? least : (t > 1.0 - least ? 1.0 - least : t);
  }
  return a;
}

}  // namespace armlet
