#pragma once

#include <Eigen/Core>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// The real zeros of a polynomial, smallest first. A root of any multiplicity is listed once; pairs
// of complex roots are left out.
//
// Between neighbouring zeros of its derivative a polynomial is monotone, so that halving finds the
// one zero there if the signs differ; where a zero of the derivative is a zero of the polynomial as
// far as rounding of its terms can tell, the root is a multiple one.
//
// c       coefficients, constant term first; highest ones of zero do not count.
// throws  ArgumentError if all coefficients are zero, one is not finite, or the degree is above 50.
// source  G. E. Collins and R. Loos, Proc. ACM Symposium on Symbolic and Algebraic Computation,
//         1976: real roots by the roots of derivatives.
std::vector<double> real_roots(const Eigen::VectorXd& c);

}  // namespace armlet
