#include "armlet/camera/interaction_matrix.hpp"

#include <fmt/format.h>

#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

void check_arguments(const Eigen::MatrixXd& pixels, const Eigen::VectorXd& depth) {
  if (pixels.rows() < 1 || pixels.cols() != 2) {
    throw ArgumentError(
        fmt::format("Points of a picture are rows of two pixels, not a matrix of "
                    "{} x {}.",
                    pixels.rows(), pixels.cols()));
  }
  if (depth.size() != 1 && depth.size() != pixels.rows()) {
    throw ArgumentError(
        fmt::format("{} depths for {} points; expected one for each, or one for "
                    "all.",
                    depth.size(), pixels.rows()));
  }
  check_finite("pixels", pixels);
  for (const double z : depth) check_positive("depth", z);
}

}  // namespace

Result<Eigen::MatrixXd> interaction_matrix(const Pinhole& camera, const Eigen::MatrixXd& pixels,
                                           const Eigen::VectorXd& depth) {
  check_arguments(pixels, depth);
  Eigen::MatrixXd L(2 * pixels.rows(), 6);
  for (Eigen::Index i = 0; i < pixels.rows(); ++i) {
    const Result<Eigen::Vector3d> ray = camera.ray(pixels.row(i).transpose());
    if (!ray) return ray.error();
    const double x = ray->x(), y = ray->y(), Z = depth[depth.size() == 1 ? 0 : i];
    Eigen::Matrix<double, 2, 6> normalised;
    normalised << -1.0 / Z, 0.0, x / Z, x * y, -(1.0 + x * x), y,  //
        0.0, -1.0 / Z, y / Z, 1.0 + y * y, -x * y, -x;
    L.middleRows<2>(2 * i) = camera.pixel_jacobian({x, y}) * normalised;
  }
  return L;
}

}  // namespace armlet
