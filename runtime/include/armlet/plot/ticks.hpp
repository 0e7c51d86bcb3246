#pragma once

#include <string>
#include <vector>

namespace armlet {

// Round values along an axis: multiples of 1, 2 or 5 times a power of ten, for degrees also of 15,
// 30, 45 and 90. `lower` and `upper` enclose what was asked for; values that are all the same get
// room to either side.
struct Ticks {
  double lower = 0.0, upper = 1.0;
  std::vector<double> at;
  std::vector<std::string> labels;  // one each, all with the same decimals

  // Where a value lies between lower (0) and upper (1).
  double position(double value) const { return (value - lower) / (upper - lower); }
};

// wanted   about how many, 2 to 12.
// whole    the axis begins and ends at a tick; otherwise at the values.
Ticks make_ticks(double lower, double upper, int wanted, bool degrees, bool whole);

}  // namespace armlet
