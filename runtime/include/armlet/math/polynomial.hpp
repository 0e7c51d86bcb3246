#pragma once

#include <Eigen/Core>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Polynomials are coefficient vectors, constant term first: p(t) = c0 + c1 t + c2 t^2 + ...

// Only fit_boundary_polynomial throws.

// Value of the derivative of the given order (0: the polynomial itself) at t.
double polynomial_value(const Eigen::VectorXd& c, double t, int derivative = 0);

// Coefficients of the derivative; for a constant the single coefficient 0.
Eigen::VectorXd polynomial_derivative(const Eigen::VectorXd& c);

// The polynomial of lowest degree with given derivatives at t = 0 and t = T.
//
// start, end  value, first derivative, second derivative, ... at the two ends; for example two
//             numbers each give a cubic, three each a quintic. Not both empty, at most 4 each.
// T           > 0.
// throws      ArgumentError on T <= 0, too many or no conditions, or values that are not finite.
Eigen::VectorXd fit_boundary_polynomial(const Eigen::VectorXd& start, const Eigen::VectorXd& end,
                                        double T);

}  // namespace armlet
