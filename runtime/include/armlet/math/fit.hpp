#pragma once

#include <Eigen/Core>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Coefficients of the polynomial of a degree with the best fit to points, constant term first: the
// sum of (p(x_i) - y_i)^2 is smallest.
//
// x, y    m values each, finite; at least degree + 1 of the x differ.
// degree  0 to 50.
// returns degree + 1 coefficients.
// throws  ArgumentError on sizes that differ, values that are not finite, a degree out of range, or
//         too few different x.
// source  G. H. Golub, Numerische Mathematik 7, 1965: least squares by orthogonal factors, here in
//         (x - middle) / half width, so that all powers are of similar size.
Eigen::VectorXd fit_polynomial(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree);

// Linear interpolation: the value at `at` of the line through neighbouring points.
//
// x       at least one value, finite and increasing: x_i < x_(i+1).
// y       as many values, finite.
// at      between x_0 and the last x.
// throws  ArgumentError if one of these conditions is violated.
double value_between(const Eigen::Ref<const Eigen::VectorXd>& x,
                     const Eigen::Ref<const Eigen::VectorXd>& y, double at);

}  // namespace armlet
