#pragma once

#include <Eigen/Core>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Damped least-squares inverse J^T (J J^T + lambda^2 I)^-1 of an m x n matrix, n x m.
//
// lambda  damping, >= 0, in the unit of the singular values. With 0 it is the pseudo-inverse and
//         singular values below 1e-12 of the largest count as zero.
// throws  ArgumentError if lambda is negative or an element is not finite.
// source  C. W. Wampler, IEEE Trans. Systems, Man and Cybernetics 16(1), 1986.
Eigen::MatrixXd damped_pseudo_inverse(const Eigen::MatrixXd& J, double lambda = 0.0);

// Projector onto the null space of J: I - V_r V_r^T, n x n.
//
// J          m x n.
// tolerance  singular values below tolerance times the largest count as zero.
// throws     ArgumentError if an element is not finite.
// source     G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013, chapter 2 (singular
//            value decomposition).
Eigen::MatrixXd null_space_projector(const Eigen::MatrixXd& J, double tolerance = 1e-9);

// Ratio of the largest to the smallest singular value; infinity if the smallest is zero.
//
// throws  ArgumentError if the matrix is empty or an element is not finite.
double condition_number(const Eigen::MatrixXd& A);

}  // namespace armlet
