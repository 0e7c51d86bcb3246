#pragma once

#include <Eigen/Core>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Coefficients of the polynomial of a degree that fits points best, constant term first: the sum of
// (p(x_i) - y_i)^2 is smallest.
//
// x, y    m values each, finite; at least degree + 1 of the x differ.
// degree  0 to 50.
// returns degree + 1 coefficients.
// throws  ArgumentError on sizes that differ, values that are not finite, a degree out of range, or
//         too few different x.
// source  G. H. Golub, Numerische Mathematik 7, 1965: least squares by orthogonal factors, here in
//         (x - middle) / half width, which keeps the powers of one size.
Eigen::VectorXd fit_polynomial(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree);

// The value at `at` of the line through neighbouring points.
//
// x       at least one value, finite and rising: x_i < x_(i+1).
// y       as many values, finite.
// at      within x_0 and the last x.
// throws  ArgumentError if one of these does not hold.
double value_between(const Eigen::Ref<const Eigen::VectorXd>& x,
                     const Eigen::Ref<const Eigen::VectorXd>& y, double at);

}  // namespace armlet
