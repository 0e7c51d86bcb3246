#include "values/ode_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace armlet::bind {
namespace {

double steps_over(double length, double step) {
  constexpr double kRest = 1e-9;  // of a step: a remainder due to rounding is not a step of its own
  return std::max(1.0, std::ceil(length / step - kRest));
}

}  // namespace

double count_steps(std::span<const double> knots, double step) {
  double count = 0.0;
  for (std::size_t k = 1; k < knots.size(); ++k) count += steps_over(knots[k] - knots[k - 1], step);
  return count;
}

std::vector<double> step_times(std::span<const double> knots, double step) {
  std::vector<double> times = {knots.front()};
  times.reserve(static_cast<std::size_t>(count_steps(knots, step)) + 1);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double begin = knots[k - 1], length = knots[k] - begin;
    const double steps = steps_over(length, step);
    for (double i = 1.0; i < steps; i += 1.0) times.push_back(begin + length * i / steps);
    times.push_back(knots[k]);
  }
  return times;
}

}  // namespace armlet::bind
