#include "armlet/dynamics/control.hpp"

#include <fmt/format.h>

#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check_at_least(std::string_view name, const Vector6d& values, bool may_be_zero) {
  check_finite(name, values);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] > 0.0 || (may_be_zero && values[i] == 0.0)) continue;
    throw ArgumentError(fmt::format("element {} of `{}` is {}; it must be {} zero", i + 1, name,
                                    values[i], may_be_zero ? "at least" : "above"));
  }
}

}  // namespace

Result<JointVector> operational_forces(const MatrixXd& M, const MatrixXd& J, const VectorXd& a,
                                       JointsIn h, JointsIn qd, double damping) {
  check_size("columns of M", M.cols(), M.rows());
  check_size("columns of J", J.cols(), M.rows());
  check_size("a", a.size(), J.rows());
  check_size("h", h.size(), M.rows());
  check_size("qd", qd.size(), M.rows());
  check_finite("a", a);
  check_finite("h", h);
  check_finite("qd", qd);
  const auto L = cholesky(M);
  if (!L.ok())
    throw ArgumentError("`M` is not positive definite; expected the inertia matrix of an arm.");
  // In the coordinates L' qd every motion has the inertia 1, and self-motions are orthogonal to the
  // rows of J L'^-1.
  const auto root = solve(L.value(), J.transpose());
  if (!root.ok()) return root.error();
  if (rank(root.value()) < J.rows()) {
    return Error{"singular", fmt::format("the tool cannot accelerate in {} directions "
                                         "independently here",
                                         J.rows())};
  }
  // The smallest of all solutions of (J L'^-1) u = a: u = L^-1 J' Lambda a.
  const auto u = solve(root.value().transpose(), a);
  if (!u.ok()) return u.error();
  VectorXd pushed = u.value();
  if (damping > 0.0) {
    const VectorXd moved = L.value().transpose() * qd;
    const auto seen = solve(root.value().transpose(), root.value().transpose() * moved);
    if (!seen.ok()) return seen.error();
    pushed -= damping * (moved - seen.value());
  }
  JointVector tau = L.value() * pushed + h;
  check_finite("torques", tau);
  return tau;
}

Compliance give_way(const Compliance& from, const Vector6d& wrench, const Vector6d& mass,
                    const Vector6d& damping, const Vector6d& stiffness, double h) {
  check_at_least("mass", mass, false);
  check_at_least("damping", damping, true);
  check_at_least("stiffness", stiffness, true);
  check_finite("wrench", wrench);
  check_finite("h", h);
  Compliance to;
  for (Eigen::Index i = 0; i < 6; ++i) {
    // [x v 1]' = A [x v 1]'.
    MatrixXd A = MatrixXd::Zero(3, 3);
    A(0, 1) = h;
    A.row(1) << -stiffness[i] / mass[i] * h, -damping[i] / mass[i] * h, wrench[i] / mass[i] * h;
    const auto flow = exponential(A);
    if (!flow.ok())
      throw ArgumentError("the motion of the compliance is beyond the range of numbers");
    to.offset[i] = flow.value()(0, 0) * from.offset[i] + flow.value()(0, 1) * from.rate[i] +
                   flow.value()(0, 2);
    to.rate[i] = flow.value()(1, 0) * from.offset[i] + flow.value()(1, 1) * from.rate[i] +
                 flow.value()(1, 2);
  }
  check_finite("offset", to.offset);
  check_finite("rate", to.rate);
  return to;
}

}  // namespace armlet
