#include "armlet/camera/interaction_matrix.hpp"

#include <fmt/format.h>

#include "armlet/math/check_finite.hpp"
#include "armlet/vision/servo_laws.hpp"

namespace armlet {
namespace {

void check_pixels(const Eigen::MatrixXd& pixels) {
  if (pixels.rows() < 1 || pixels.cols() != 2) {
    throw ArgumentError(
        fmt::format("Points of a picture are rows of two pixels, not a matrix of "
                    "{} x {}.",
                    pixels.rows(), pixels.cols()));
  }
  check_finite("pixels", pixels);
}

}  // namespace

Result<Eigen::MatrixXd> interaction_matrix(const Pinhole& camera, const Eigen::MatrixXd& pixels,
                                           const Eigen::VectorXd& depth) {
  check_pixels(pixels);
  PlanePoints points(pixels.rows(), 2);
  for (Eigen::Index i = 0; i < pixels.rows(); ++i) {
    const Result<Eigen::Vector3d> ray = camera.ray(pixels.row(i).transpose());
    if (!ray) return ray.error();
    points.row(i) << ray->x(), ray->y();
  }
  Eigen::MatrixXd L = point_interaction(points, depth);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    L.middleRows<2>(2 * i) = camera.pixel_jacobian(points.row(i)) * L.middleRows<2>(2 * i).eval();
  return L;
}

}  // namespace armlet
