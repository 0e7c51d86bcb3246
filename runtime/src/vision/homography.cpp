#include "armlet/vision/homography.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kBlock = 64;               // points whose equations are processed at once
constexpr double kSmallestSecond = 1e-10;  // relative bound on a singular value of the equations

// Moves the points to their centre and scales them to a mean distance of sqrt(2); the zero matrix
// if they all coincide.
Matrix3d normaliser(const PlanePoints& points) {
  const Eigen::RowVector2d middle = points.colwise().mean();
  double distance = 0.0;
  for (Index i = 0; i < points.rows(); ++i) distance += (points.row(i) - middle).norm();
  distance /= static_cast<double>(points.rows());
  if (!(distance > 0.0)) return Matrix3d::Zero();
  const double scale = std::sqrt(2.0) / distance;
  Matrix3d T;
  T << scale, 0, -scale * middle.x(), 0, scale, -scale * middle.y(), 0, 0, 1;
  return T;
}

// The triangular matrix with the singular values of all equations, 9 x 9: computed block by block,
// so that memory does not grow with the number of points.
MatrixXd triangle_of_equations(const PlanePoints& a, const PlanePoints& b) {
  MatrixXd triangle = MatrixXd::Zero(9, 9);
  for (Index first = 0; first < a.rows(); first += kBlock) {
    const Index count = std::min(kBlock, a.rows() - first);
    MatrixXd rows = MatrixXd::Zero(9 + 2 * count, 9);
    rows.topRows(9) = triangle;
    for (Index i = 0; i < count; ++i) {
      const double x = a(first + i, 0), y = a(first + i, 1);
      const double u = b(first + i, 0), v = b(first + i, 1);
      rows.row(9 + 2 * i) << -x, -y, -1, 0, 0, 0, u * x, u * y, u;
      rows.row(10 + 2 * i) << 0, 0, 0, -x, -y, -1, v * x, v * y, v;
    }
    triangle = triangle_of(rows);
  }
  return triangle;
}

PlanePoints normalised(const Matrix3d& T, const PlanePoints& points) {
  PlanePoints out(points.rows(), 2);
  for (Index i = 0; i < points.rows(); ++i)
    out.row(i) << T(0, 0) * points(i, 0) + T(0, 2), T(1, 1) * points(i, 1) + T(1, 2);
  return out;
}

// Products of larger coordinates could overflow.
void check_range(std::string_view name, const PlanePoints& points) {
  constexpr double kMost = 1e100;
  const double largest = points.cwiseAbs().maxCoeff();
  if (largest <= kMost) return;
  throw ArgumentError(fmt::format("The largest coordinate of `{}` is {:g}; expected at most {:g}.",
                                  name, largest, kMost));
}

// Why points of one picture determine no homography; empty: they are not at fault by themselves.
std::string fault_of(std::string_view use, const Matrix3d& T, const PlanePoints& points) {
  if (T.isZero(0.0)) return fmt::format("the points to {} are all at one place", use);
  const VectorXd s = singular_values(normalised(T, points)).s;
  if (s[1] >= kSmallestSecond * s[0]) return {};
  return fmt::format("the points to {} are all on one line", use);
}

}  // namespace

Result<Matrix3d> homography(const PlanePoints& from, const PlanePoints& to) {
  if (from.rows() != to.rows()) {
    throw ArgumentError(fmt::format("{} points cannot be taken to {}.", from.rows(), to.rows()));
  }
  if (from.rows() < 4) {
    throw ArgumentError(fmt::format("A homography needs at least 4 points, not {}.", from.rows()));
  }
  check_finite("from", from);
  check_finite("to", to);
  check_range("from", from);
  check_range("to", to);
  const Matrix3d T_from = normaliser(from), T_to = normaliser(to);
  const auto undetermined = [&] {
    std::string why = fault_of("map from", T_from, from);
    if (why.empty()) why = fault_of("map to", T_to, to);
    if (why.empty())
      why = "a homography needs four pairs of points of which no three are on one line";
    return Error{"degenerate", why};
  };
  if (T_from.isZero(0.0) || T_to.isZero(0.0)) return undetermined();
  const SvdParts parts =
      full_singular_values(triangle_of_equations(normalised(T_from, from), normalised(T_to, to)));
  if (parts.s[7] < kSmallestSecond * parts.s[0]) return undetermined();
  const Eigen::VectorXd h = parts.V.col(8);
  Matrix3d N;
  N << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  Matrix3d back;  // the inverse of T_to
  back << 1 / T_to(0, 0), 0, -T_to(0, 2) / T_to(0, 0), 0, 1 / T_to(1, 1), -T_to(1, 2) / T_to(1, 1),
      0, 0, 1;
  Matrix3d H = back * N * T_from;
  const double last = H(2, 2), size = H.norm();
  H /= std::abs(last) > 1e-12 * size ? last : size;
  // A map onto a line is not a homography.
  if (std::abs(N.determinant()) < kSmallestSecond) return undetermined();
  return H;
}

PlanePoints map_points(const Matrix3d& H, const PlanePoints& points) {
  PlanePoints out(points.rows(), 2);
  for (Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = H * Eigen::Vector3d(points(i, 0), points(i, 1), 1.0);
    out.row(i) << p.x() / p.z(), p.y() / p.z();
    if (!out.row(i).allFinite()) {
      throw ArgumentError(fmt::format("The map takes point {}, ({}, {}), to infinity.", i + 1,
                                      points(i, 0), points(i, 1)));
    }
  }
  return out;
}

}  // namespace armlet
