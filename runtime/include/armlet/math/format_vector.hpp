#pragma once

#include <Eigen/Core>
#include <string>

#include "armlet/core/format.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// "(0.1, 2, -3.25)"
std::string format_vector(const Eigen::VectorXd& values, int digits = 3);

// "(180, -264.2, 20) mm" from metres.
std::string format_point_mm(const Eigen::Vector3d& p);

}  // namespace armlet
