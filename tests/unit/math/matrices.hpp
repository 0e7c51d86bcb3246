#pragma once

#include <Eigen/Core>
#include <initializer_list>

#include "armlet/core/random.hpp"

namespace armlet {

// A vector of these elements; Eigen's own list constructor takes rows.
inline Eigen::VectorXd vec(std::initializer_list<double> values) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) out[i++] = value;
  return out;
}

// rows x cols, elements uniform in [-1, 1).
inline Eigen::MatrixXd random_matrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
  Eigen::MatrixXd A(rows, cols);
  for (double& a : A.reshaped()) a = random.uniform(-1, 1);
  return A;
}

}  // namespace armlet
