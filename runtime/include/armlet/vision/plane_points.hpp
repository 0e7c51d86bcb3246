#pragma once

#include <Eigen/Core>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Points of a plane or of a picture, one in each row: n x 2.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

}  // namespace armlet
