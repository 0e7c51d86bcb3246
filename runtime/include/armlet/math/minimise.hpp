#pragma once
// Minimum of a function of several numbers.

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Writes f(x) to `value`; infinity means that x is not allowed. Returns false to end the search.
using VectorFunction = std::function<bool(const Eigen::VectorXd& x, double& value)>;

struct MinimiseOptions {
  double tolerance = 1e-8;        // of x, relative to max(|x_i|, 1)
  int most_evaluations = 50'000;  // times the number of variables
};

struct Minimum {
  enum class Status : std::uint8_t {
    kFound,
    kStopped,     // the function returned false
    kUndefined,   // f(x) is NaN
    kBottomless,  // f(x) is minus infinity
    kTooMany,     // most_evaluations did not suffice
  };
  Status status = Status::kFound;
  Eigen::VectorXd x;   // the best x found, or the x of a failure
  double value = 0.0;  // f(x)
  int evaluations = 0;
};

// A local minimum of f, found from `start` without derivatives.
//
// The simplex method of Nelder and Mead with coefficients that depend on the number of variables. A
// search ends when all vertices are within the tolerance of the best one and the values differ by
// rounding only. It is restarted around the best point until that no longer helps, because a
// simplex can collapse before it reaches the minimum.
//
// start   at least one value, all finite, and f finite there.
// throws  ArgumentError on an empty or infinite start.
// source  J. A. Nelder and R. Mead, The Computer Journal 7(4), 1965; F. Gao and L. Han,
//         Computational Optimization and Applications 51(1), 2012, eq. 4.1.
[[nodiscard]] Minimum minimise(const VectorFunction& f, const Eigen::VectorXd& start,
                               const MinimiseOptions& options = {});

}  // namespace armlet
