#pragma once

#include <Eigen/Core>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// The real zeros of a polynomial, smallest first. A root of any multiplicity is listed once; pairs
// of complex roots are left out.
//
// Between neighbouring zeros of its derivative a polynomial is monotone, so bisection finds the
// only zero there if the signs differ. Where a zero of the derivative is also a zero of the
// polynomial within rounding, it is a multiple root.
//
// c       coefficients, constant term first; leading zeros are ignored.
// throws  ArgumentError if all coefficients are zero, one is not finite, or the degree is above 50.
// source  G. E. Collins and R. Loos, Proc. ACM Symposium on Symbolic and Algebraic Computation,
//         1976: real roots by the roots of derivatives.
std::vector<double> real_roots(const Eigen::VectorXd& c);

}  // namespace armlet
