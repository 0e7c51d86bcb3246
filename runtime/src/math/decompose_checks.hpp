#pragma once
// Checks of arguments and results of the decompositions.

#include <Eigen/Core>
#include <string_view>

#include "armlet/core/error.hpp"

namespace armlet {

// Throws ArgumentError for a matrix that is not finite, too large, or not square.
void check_matrix(std::string_view name, const Eigen::MatrixXd& A);
void check_square(std::string_view name, const Eigen::MatrixXd& A);

// The error "overflow" instead of infinite or undefined numbers.
Result<Eigen::MatrixXd> finite(Eigen::MatrixXd result);

// Whether it equals its transpose within rounding.
bool is_symmetric(const Eigen::MatrixXd& A);

}  // namespace armlet
