#include "armlet/kinematics/manipulability.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>

namespace armlet {
namespace {

// Rank of the translational rows in a configuration without symmetry; a planar arm has two.
Eigen::Index translation_rank(const Robot& robot) {
  Eigen::Index rank = 0;
  for (int sample = 1; sample <= 3; ++sample) {
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) {
      const double share = 0.13 + 0.74 * ((sample * (i + 1) * 37) % 101) / 101.0;
      q[i] = robot.lower()[i] + share * (robot.upper()[i] - robot.lower()[i]);
    }
    const Eigen::MatrixXd Jv = jacobian(robot, q).topRows<3>();
    const Eigen::VectorXd sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(Jv).singularValues();
    rank = std::max<Eigen::Index>(rank, (sigma.array() > 1e-9 * robot.length()).count());
  }
  return std::max<Eigen::Index>(rank, 1);
}

}  // namespace

double manipulability(const Robot& robot, JointsIn q) {
  const Jacobian J = jacobian(robot, q);
  if (robot.n() >= 6) {
    const Eigen::VectorXd sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues();
    return sigma.prod();
  }
  const Eigen::MatrixXd Jv = J.topRows<3>();
  const Eigen::VectorXd sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(Jv).singularValues();
  return sigma.head(std::min(translation_rank(robot), sigma.size())).prod();
}

Singularity singularity(const Robot& robot, JointsIn q) {
  Eigen::MatrixXd J = jacobian(robot, q);
  const bool place_only = robot.n() <= 3;
  J.bottomRows<3>() *= place_only ? 0.0 : robot.length();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::Index directions =
      place_only ? translation_rank(robot) : std::min<Eigen::Index>(6, robot.n());
  const Eigen::Index last = std::min(directions, svd.singularValues().size()) - 1;
  Singularity result;
  result.sigma_min = svd.singularValues()[last];
  result.direction = svd.matrixU().col(last);
  result.joints = svd.matrixV().col(svd.matrixV().cols() - 1);
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
  u = (u * 100.0).array().round() / 100.0 + 0.0;  // adding 0 turns -0 into 0
  return fmt::format("cannot {} ({:.2f}, {:.2f}, {:.2f})", linear ? "move along" : "rotate about",
                     u.x(), u.y(), u.z());
}

}  // namespace armlet
