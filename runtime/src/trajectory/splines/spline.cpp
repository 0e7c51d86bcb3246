#include "armlet/trajectory/spline.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/profile.hpp"
#include "trajectory/splines/spline_points.hpp"

namespace armlet {

void check_points(std::span<const double> t, std::span<const double> q) {
  check_size("q", static_cast<Eigen::Index>(q.size()), static_cast<Eigen::Index>(t.size()));
  if (t.size() < 2) throw ArgumentError("A spline needs at least two points.");
  if (t[0] != 0.0) {
    throw ArgumentError(fmt::format("The first point of a spline is at {} s; expected 0 s.", t[0]));
  }
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!(t[i] > t[i - 1])) {
      throw ArgumentError(
          fmt::format("The times of a spline must ascend; {} s follows {} s.", t[i], t[i - 1]));
    }
  }
}

namespace {

// The speeds at the points follow from the continuity of the acceleration. The system is
// tridiagonal and diagonally dominant, so elimination needs no pivots.
std::vector<double> point_speeds(std::span<const double> t, std::span<const double> q,
                                 double v_start, double v_end) {
  const std::size_t last = t.size() - 1;
  std::vector<double> upper(t.size(), 0.0);
  std::vector<double> v(t.size(), 0.0);
  v[0] = v_start;
  for (std::size_t i = 1; i < last; ++i) {
    const double h0 = t[i] - t[i - 1];
    const double h1 = t[i + 1] - t[i];
    const double rhs = 3.0 * (h0 * (q[i + 1] - q[i]) / h1 + h1 * (q[i] - q[i - 1]) / h0);
    const double pivot = 2.0 * (h0 + h1) - h1 * upper[i - 1];
    upper[i] = h0 / pivot;
    v[i] = (rhs - h1 * v[i - 1]) / pivot;
  }
  v[last] = v_end;
  for (std::size_t i = last - 1; i > 0; --i) v[i] -= upper[i] * v[i + 1];
  return v;
}

}  // namespace

std::vector<Segment> cubic_spline(std::span<const double> t, std::span<const double> q,
                                  double v_start, double v_end) {
  check_points(t, q);
  const std::vector<double> v = point_speeds(t, q, v_start, v_end);
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    pieces.push_back(
        cubic_segment({.q = q[i], .v = v[i]}, {.q = q[i + 1], .v = v[i + 1]}, t[i + 1] - t[i]));
    pieces.back().start = t[i];
  }
  return pieces;
}

std::vector<Segment> natural_spline(std::span<const double> t, std::span<const double> q) {
  check_points(t, q);
  const std::size_t last = t.size() - 1;
  // The accelerations at the points follow from the continuity of the speed, by a tridiagonal
  // system.
  std::vector<double> upper(t.size(), 0.0);
  std::vector<double> a(t.size(), 0.0);
  for (std::size_t i = 1; i < last; ++i) {
    const double h0 = t[i] - t[i - 1];
    const double h1 = t[i + 1] - t[i];
    const double rhs = 6.0 * ((q[i + 1] - q[i]) / h1 - (q[i] - q[i - 1]) / h0);
    const double pivot = 2.0 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    a[i] = (rhs - h0 * a[i - 1]) / pivot;
  }
  for (std::size_t i = last; i-- > 1;) a[i] -= upper[i] * a[i + 1];
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < last; ++i) {
    const double h = t[i + 1] - t[i];
    const double v = (q[i + 1] - q[i]) / h - h * (2.0 * a[i] + a[i + 1]) / 6.0;
    pieces.push_back({.start = t[i],
                      .duration = h,
                      .degree = 3,
                      .c = {q[i], v, 0.5 * a[i], (a[i + 1] - a[i]) / (6.0 * h)}});
  }
  return pieces;
}

}  // namespace armlet
