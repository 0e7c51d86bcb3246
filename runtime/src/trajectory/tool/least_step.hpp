// The step of the joints that follows the tool with the least cost, within bounds.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace armlet {

// The conditions on a step of n joints: A x = b, and among such steps x^T W x - 2 g^T x is least.
//
// W  n x n, positive definite.
// A  m x n, m <= n.
struct StepTask {
  Eigen::MatrixXd W;
  Eigen::VectorXd g;
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

// The step of least cost with lower <= x <= upper: joints that would go beyond are held at their
// bound, the one that would go farthest first, and the others compensate for them. Empty if too few
// joints are left.
//
// source  F. Flacco, A. De Luca, O. Khatib, Motion control of redundant robots under joint
//         constraints: saturation in the null space, ICRA 2012; least squares with equality
//         constraints: Golub, Van Loan, Matrix Computations, 4th ed., 2013, section 6.2.
std::optional<Eigen::VectorXd> least_step(const StepTask& task, const Eigen::VectorXd& lower,
                                          const Eigen::VectorXd& upper);

}  // namespace armlet
