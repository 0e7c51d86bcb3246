#pragma once

#include "armlet/core/random.hpp"

namespace armlet {

// A normally distributed number with mean 0 and standard deviation 1.
//
// source  G. Marsaglia and T. A. Bray, SIAM Review 6(3), 1964 (polar method).
double normal(Random& random);

}  // namespace armlet
