#include "armlet/math/format_vector.hpp"

namespace armlet {

std::string format_vector(const Eigen::VectorXd& values, int digits) {
  std::string text = "(";
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (i > 0) text += ", ";
    text += format_number(values[i], digits);
  }
  return text + ")";
}

std::string format_point_mm(const Eigen::Vector3d& p) {
  return format_vector(p * 1000.0, 1) + " mm";
}

}  // namespace armlet
