#pragma once

#include <string>
#include <vector>

namespace armlet {

// Round values along an axis: multiples of 1, 2 or 5 times a power of ten, for degrees also of 15,
// 30, 45 and 90. `lower` and `upper` enclose the requested range; an empty range is widened to both
// sides.
struct Ticks {
  double lower = 0.0, upper = 1.0;
  std::vector<double> at;
  std::vector<std::string> labels;  // one each, all with the same number of decimals
  std::vector<double> minor{};      // further lines of the grid, without a label
  bool log = false;

  // Relative position of a value between lower (0) and upper (1).
  double position(double value) const;
};

// wanted   approximate number of ticks, 2 to 12.
// whole    the axis begins and ends at a tick; otherwise at the values.
Ticks make_ticks(double lower, double upper, int wanted, bool degrees, bool whole);

// Powers of ten, or 1, 2 and 5 times those if the values span less than two of them. The axis
// begins and ends at such a value; 2 to 9 times a power of ten are `minor`.
//
// lower, upper   > 0
Ticks make_log_ticks(double lower, double upper, int wanted);

// An axis parallel to another whole one, with the same number of steps, so that one grid serves
// both; their zeros are at the same height if both show zero and neither becomes much longer
// because of it.
Ticks make_parallel_ticks(double lower, double upper, const Ticks& other, bool degrees);

// 0, 1, 2, ... with a name instead of a value each, and half a step of room at the ends.
Ticks make_name_ticks(const std::vector<std::string>& names);

}  // namespace armlet
