#include "armlet/math/polynomial.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

// k (k-1) ... (k-order+1): the factor that differentiating t^k produces.
double falling_factorial(Eigen::Index k, Eigen::Index order) {
  double product = 1.0;
  for (Eigen::Index i = 0; i < order; ++i) product *= static_cast<double>(k - i);
  return product;
}

}  // namespace

double polynomial_value(const Eigen::VectorXd& c, double t, int derivative) {
  double value = 0.0;
  for (Eigen::Index k = c.size() - 1; k >= derivative; --k) {
    value = value * t + falling_factorial(k, derivative) * c[k];
  }
  return value;
}

Eigen::VectorXd polynomial_derivative(const Eigen::VectorXd& c) {
  if (c.size() <= 1) return Eigen::VectorXd::Zero(1);
  Eigen::VectorXd d(c.size() - 1);
  for (Eigen::Index k = 1; k < c.size(); ++k) d[k - 1] = static_cast<double>(k) * c[k];
  return d;
}

Eigen::VectorXd fit_boundary_polynomial(const Eigen::VectorXd& start, const Eigen::VectorXd& end,
                                        double T) {
  check_finite("start", start);
  check_finite("end", end);
  check_positive("T", T);
  const Eigen::Index m = start.size();
  const Eigen::Index k = end.size();
  if (m + k == 0 || m > 4 || k > 4) {
    throw ArgumentError(fmt::format(
        "{} conditions at the start and {} at the end were given; expected up to 4 each and at "
        "least one.",
        m, k));
  }
  // The lower coefficients follow from the start alone; only the upper k are unknown. The unit of
  // time is T, which keeps the small system well conditioned for every T.
  Eigen::VectorXd c = Eigen::VectorXd::Zero(m + k);
  double scale = 1.0;
  for (Eigen::Index i = 0; i < m; ++i) {
    c[i] = start[i] * scale / falling_factorial(i, i);
    scale *= T;
  }
  Eigen::MatrixXd A(k, k);
  Eigen::VectorXd b(k);
  scale = 1.0;
  for (Eigen::Index row = 0; row < k; ++row) {
    b[row] = end[row] * scale - polynomial_value(c, 1.0, static_cast<int>(row));
    for (Eigen::Index col = 0; col < k; ++col) A(row, col) = falling_factorial(m + col, row);
    scale *= T;
  }
  if (k > 0) c.tail(k) = A.partialPivLu().solve(b);
  double power = 1.0;
  for (double& coefficient : c) {
    coefficient /= power;
    power *= T;
  }
  return c;
}

}  // namespace armlet
