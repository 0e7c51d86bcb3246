// Paths of the joints over their length, for the tests of time along a path.
#pragma once

#include <random>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "uniform.hpp"

namespace armlet {

// One joint that moves from 0 to L, L > 0; the parameter is its position.
inline Trajectory straight_line(double L) {
  return {{{{{.duration = L, .degree = 1, .c = {0.0, 1.0}}}, L}}, L};
}

// A path of n joints through at least three and at most `most` random points, each within 2 rad or
// m of zero.
inline Trajectory random_path(std::mt19937_64& generator, int n, unsigned most) {
  std::vector<Eigen::VectorXd> points(3 + generator() % (most - 2), Eigen::VectorXd(n));
  for (Eigen::VectorXd& point : points) {
    for (double& q : point) q = uniform(generator, -2.0, 2.0);
  }
  return path_through(points);
}

}  // namespace armlet
