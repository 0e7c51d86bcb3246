#pragma once
// Functions of one number that chapters apply to a number, to each number of a list and to each
// element of a matrix.

#include <cmath>

namespace armlet::bind {

using Real1 = double (*)(double);

inline double absolute(double x) { return std::abs(x); }
inline double square_root(double x) { return x >= 0.0 ? std::sqrt(x) : std::nan(""); }
inline double round_down(double x) { return std::floor(x); }
inline double round_up(double x) { return std::ceil(x); }

}  // namespace armlet::bind
