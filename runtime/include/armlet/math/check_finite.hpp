#pragma once

#include <Eigen/Core>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Throws ArgumentError naming the element that is not a number or infinite.
void check_finite(std::string_view name, const Eigen::Ref<const Eigen::MatrixXd>& values);

}  // namespace armlet
