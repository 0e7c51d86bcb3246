#include "armlet/math/normal.hpp"

#include <cmath>

#include "armlet/math/det_math.hpp"

namespace armlet {

double normal(Random& random) {
  double u = 0.0;
  double s = 0.0;
  do {
    u = random.uniform(-1.0, 1.0);
    const double v = random.uniform(-1.0, 1.0);
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  return u * std::sqrt(-2.0 * det::log(s) / s);
}

}  // namespace armlet
