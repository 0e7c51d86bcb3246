#include "link_parameters.hpp"

namespace armlet {
namespace {

// The second moment tr(I) / 2 - I of a body whose inertia about the origin is 1 in this element and
// 0 elsewhere.
Moments unit_inertia(int row, int column) {
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  I(row, column) = I(column, row) = 1.0;
  Moments body;
  body.S = 0.5 * I.trace() * Eigen::Matrix3d::Identity() - I;
  return body;
}

}  // namespace

Eigen::Matrix<double, kMassParameters, 1> mass_parameters(const Moments& body) {
  const Eigen::Matrix3d I = body.S.trace() * Eigen::Matrix3d::Identity() - body.S;
  Eigen::Matrix<double, kMassParameters, 1> p;
  p << body.mass, body.h, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return p;
}

Moments unit_body(int k) {
  constexpr int kPlaces[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  if (k >= 4) return unit_inertia(kPlaces[k - 4][0], kPlaces[k - 4][1]);
  Moments body;
  (k == 0 ? body.mass : body.h[k - 1]) = 1.0;
  return body;
}

}  // namespace armlet
