// A path through points, and the time that a run along a path takes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/spline.hpp"
#include "armlet/trajectory/time_optimal.hpp"

namespace armlet {

std::vector<double> SpeedAlongPath::times() const {
  std::vector<double> t = {0.0};
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    const double v = std::sqrt(squared[k]) + std::sqrt(squared[k + 1]);
    t.push_back(t.back() + 2.0 * (s[k + 1] - s[k]) / v);
  }
  return t;
}

double SpeedAlongPath::duration() const { return times().back(); }

double SpeedAlongPath::time_at(double position) const {
  double T = 0.0;
  for (std::size_t k = 0; k + 1 < s.size() && s[k] < position; ++k) {
    const double v0 = std::sqrt(squared[k]);
    const double step = std::min(position, s[k + 1]) - s[k];
    const double part = step / (s[k + 1] - s[k]);
    const double v1 = std::sqrt(squared[k] + part * (squared[k + 1] - squared[k]));
    T += 2.0 * step / (v0 + v1);
  }
  return T;
}

Trajectory path_through(std::span<const Eigen::VectorXd> points) {
  if (points.size() < 2) throw ArgumentError("A path needs at least two points.");
  std::vector<double> s = {0.0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    check_size("points", points[k].size(), points[0].size());
    check_finite("points", points[k]);
    const double distance = (points[k] - points[k - 1]).norm();
    if (!(distance > 0.0)) {
      throw ArgumentError(
          fmt::format("Points {} and {} of the path are the same; leave one out.", k, k + 1));
    }
    s.push_back(s.back() + std::sqrt(distance));
  }
  std::vector<JointPath> joints;
  std::vector<double> q(points.size());
  for (Eigen::Index i = 0; i < points[0].size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) q[k] = points[k][i];
    joints.push_back({.segments = natural_spline(s, q), .q_end = q.back()});
  }
  return {std::move(joints), s.back()};
}

}  // namespace armlet
