#include "armlet/kinematics/manipulability.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/math/decompose.hpp"

namespace armlet {
namespace {

// Directions in which this arm can move, as orthonormal columns, with rotations scaled by the arm's
// length: all those that it has in a few configurations without symmetry. A planar arm never leaves
// its plane, so it cannot lose that direction.
Eigen::MatrixXd possible_motions(const Robot& robot, bool position_only) {
  const Eigen::Index n = robot.n();
  Eigen::MatrixXd samples(6, 3 * n);
  for (Eigen::Index k = 0; k < 3; ++k) {
    Eigen::VectorXd q(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double share =
          0.13 + 0.74 * static_cast<double>(((k + 1) * (i + 1) * 37) % 101) / 101.0;
      q[i] = robot.lower()[i] + share * (robot.upper()[i] - robot.lower()[i]);
    }
    samples.middleCols(k * n, n) = jacobian(robot, q);
  }
  samples.bottomRows<3>() *= position_only ? 0.0 : robot.length();
  const SvdParts svd = singular_values(samples);
  const Eigen::Index rank = (svd.s.array() > 1e-9 * std::max(svd.s[0], 1e-300)).count();
  return svd.U.leftCols(std::max<Eigen::Index>(rank, 1));
}

// The matrix that selects the relevant rows of the Jacobian.
Eigen::MatrixXd counting_rows(const Robot& robot) {
  if (robot.n() >= 6) return Eigen::MatrixXd::Identity(6, 6);
  Eigen::MatrixXd rows = possible_motions(robot, true).transpose();
  rows.rightCols<3>().setZero();
  return rows;
}

}  // namespace

double manipulability(const Robot& robot, JointsIn q) {
  return singular_values(counting_rows(robot) * jacobian(robot, q)).s.prod();
}

Eigen::VectorXd manipulability_gradient(const Robot& robot, JointsIn q) {
  const Eigen::MatrixXd rows = counting_rows(robot);
  const SvdParts svd = singular_values(rows * jacobian(robot, q));
  Eigen::VectorXd others = Eigen::VectorXd::Ones(svd.s.size());
  for (Eigen::Index k = 0; k < others.size(); ++k) {
    for (Eigen::Index j = 0; j < others.size(); ++j) others[k] *= j == k ? 1.0 : svd.s[j];
  }
  Eigen::VectorXd gradient(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const Eigen::MatrixXd rate =
        rows * jacobian_rate(robot, q, Eigen::VectorXd::Unit(robot.n(), i));
    gradient[i] = others.dot((svd.U.transpose() * rate * svd.V).diagonal());
  }
  return gradient;
}

Singularity singularity(const Robot& robot, JointsIn q) {
  const bool position_only = robot.n() <= 3;
  Eigen::MatrixXd J = jacobian(robot, q);
  J.bottomRows<3>() *= position_only ? 0.0 : robot.length();
  const Eigen::MatrixXd motions = possible_motions(robot, position_only);
  const SvdParts svd = full_singular_values(motions.transpose() * J);
  const Eigen::Index last = svd.s.size() - 1;
  Singularity result;
  result.length = robot.length();
  result.sigma = svd.s;
  result.sigma_min = result.sigma[last];
  result.direction = motions * svd.U.col(last);
  result.joints = svd.V.col(robot.n() - 1);
  return result;
}

std::string describe(const Singularity& singularity) {
  const Eigen::Vector3d v = singularity.direction.head<3>();
  const Eigen::Vector3d w = singularity.direction.tail<3>();
  const bool linear = v.norm() >= w.norm();
  Eigen::Vector3d u = linear ? v : w;
  if (u.norm() > 0.0) u /= u.norm();
  Eigen::Index largest = 0;
  u.cwiseAbs().maxCoeff(&largest);
  if (u[largest] < 0.0) u = -u;
  u = (u * 100.0).array().round() / 100.0 + 0.0;  // adding 0 changes -0 to 0
  return fmt::format("cannot {} ({:.2f}, {:.2f}, {:.2f})", linear ? "move along" : "rotate about",
                     u.x(), u.y(), u.z());
}

}  // namespace armlet
