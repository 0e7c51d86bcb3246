#include "position_model.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/pose.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFlat = 1e-8;  // of the square of the arm's length
// The same, added to every second derivative: joints hardly move where the distance hardly depends
// on them.
constexpr double kDamping = 1e-4;
constexpr double kStationary = 1e-3;  // first derivative of the distance, of the arm's length
constexpr double kNudge = 0.05;       // rad, off a saddle
constexpr double kLargestPart = 0.3;  // rad, or share of the arm's length
constexpr double kOnLimit = 1e-12;    // rad or m
// Newton's method on a fold of the arm would arrive at the stretched arm exactly, or just beyond.
// Steps that are a tenth shorter approach it from one side, so that the elbow keeps its side.
constexpr double kFoldFactor = 1.1;

MatrixXd part_of(const MatrixXd& A, const std::vector<Index>& at) { return A(at, at); }

// The component of the step along an eigenvector of the second derivative.
//
// by_jacobian  the part of the second derivative that J^T J gives; the rest is that of a fold.
double newton_part(double gradient, double curvature, double by_jacobian, double damping) {
  const double size = std::abs(curvature) + damping;
  return -gradient / (by_jacobian < 0.5 * size ? kFoldFactor * size : size);
}

void shorten(VectorXd& step) {
  const double largest = step.cwiseAbs().maxCoeff();
  if (largest > kLargestPart) step *= kLargestPart / largest;
}

}  // namespace

PositionModel::PositionModel(const Robot& robot, const Eigen::Isometry3d& T_goal)
    : robot_(robot),
      T_goal_(T_goal),
      scale_(VectorXd::Ones(robot.n())),
      flat_(kFlat * robot.length() * robot.length()),
      damping_(kDamping * robot.length() * robot.length()) {
  for (int i = 0; i < robot.n(); ++i)
    if (!robot.is_revolute(i)) scale_[i] = robot.length();
}

PositionModel::At PositionModel::at(const VectorXd& q) const {
  At out;
  out.error = pose_error(forward_and_jacobian(robot_, q, out.J), T_goal_);
  out.J = out.J * scale_.asDiagonal();
  return out;
}

// J^T J less the error times the second derivative of the position.
MatrixXd PositionModel::hessian(const VectorXd& q, const At& at) const {
  const Index n = q.size();
  MatrixXd H = at.J.topRows<3>().transpose() * at.J.topRows<3>();
  VectorXd rate = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    rate[i] = scale_[i];
    const Jacobian change = jacobian_rate(robot_, q, rate);
    rate[i] = 0.0;
    H.col(i) -= scale_.cwiseProduct(change.topRows<3>().transpose() * at.error.head<3>());
  }
  return 0.5 * (H + H.transpose());
}

bool PositionModel::leaves(const VectorXd& q, Index i, double direction) const {
  return (q[i] >= robot_.upper()[i] - kOnLimit && direction > 0.0) ||
         (q[i] <= robot_.lower()[i] + kOnLimit && direction < 0.0);
}

PositionModel::Joints PositionModel::free_joints(const VectorXd& q, const VectorXd& push) const {
  Joints joints;
  for (Index i = 0; i < q.size(); ++i)
    if (!leaves(q, i, push[i])) joints.push_back(i);
  return joints;
}

bool PositionModel::drop_leaving(const VectorXd& q, const VectorXd& step, Joints& joints) const {
  return std::erase_if(joints, [&](Index i) { return leaves(q, i, step[i]); }) > 0;
}

VectorXd PositionModel::step(const VectorXd& q, const At& at) const {
  const MatrixXd H = hessian(q, at);
  const MatrixXd GN = at.J.topRows<3>().transpose() * at.J.topRows<3>();
  const VectorXd push = at.J.topRows<3>().transpose() * at.error.head<3>();
  const double length = robot_.length();
  const VectorXd middle = 0.5 * (robot_.lower() + robot_.upper()) - q;
  Joints joints = free_joints(q, push);
  VectorXd step;
  do {
    step = VectorXd::Zero(q.size());
    if (joints.empty()) break;
    const SymmetricEigen eigen = symmetric_eigen(part_of(H, joints));
    const VectorXd free_push = push(joints);
    const bool is_saddle = free_push.norm() < kStationary * length * at.distance();
    VectorXd parts(eigen.values.size());
    for (Index k = 0; k < parts.size(); ++k) {
      const VectorXd v = eigen.vectors.col(k);
      const double by_jacobian = v.dot(part_of(GN, joints) * v);
      parts[k] = newton_part(-v.dot(free_push), eigen.values[k], by_jacobian, damping_);
      // Off a saddle in the direction in which the distance decreases most.
      if (k > 0 || !is_saddle || eigen.values[0] > -flat_ || std::abs(parts[0]) > kNudge) continue;
      const double side = v.dot(free_push) != 0.0 ? v.dot(free_push) : v.dot(middle(joints));
      parts[0] = std::copysign(kNudge, side);
    }
    step(joints) = eigen.vectors * parts;
  } while (drop_leaving(q, step, joints));
  shorten(step);
  return scale_.cwiseProduct(step);
}

VectorXd PositionModel::rotation_step(const VectorXd& q, const At& at, double damping) const {
  const MatrixXd H = hessian(q, at);
  const VectorXd push = at.J.topRows<3>().transpose() * at.error.head<3>();
  // While the point is not reached, the joints that would bring it nearer stay at their limits.
  Joints joints = free_joints(q, at.distance() > 1e-6 ? push : VectorXd(VectorXd::Zero(q.size())));
  VectorXd step;
  do {
    step = VectorXd::Zero(q.size());
    if (joints.empty()) break;
    const SymmetricEigen eigen = symmetric_eigen(part_of(H, joints));
    std::vector<Index> flat;
    for (Index k = 0; k < eigen.values.size(); ++k)
      if (std::abs(eigen.values[k]) <= flat_) flat.push_back(k);
    if (flat.empty()) break;
    const MatrixXd N = eigen.vectors(Eigen::all, flat);
    const MatrixXd J = at.J(Eigen::seqN(3, 3), joints) * N;
    MatrixXd A = J.transpose() * J;
    A.diagonal().array() += damping;
    step(joints) =
        N * SymmetricFactors<Eigen::Dynamic>(A).solve(J.transpose() * at.error.tail<3>());
  } while (drop_leaving(q, step, joints));
  shorten(step);
  return scale_.cwiseProduct(step);
}

std::vector<int> PositionModel::stopping(const VectorXd& q, const At& at, bool has_position) const {
  const VectorXd push = has_position
                            ? VectorXd(at.J.bottomRows<3>().transpose() * at.error.tail<3>())
                            : VectorXd(at.J.topRows<3>().transpose() * at.error.head<3>());
  std::vector<int> joints;
  for (Index i = 0; i < q.size(); ++i)
    if (std::abs(push[i]) > 1e-6 && leaves(q, i, push[i])) joints.push_back(static_cast<int>(i));
  return joints;
}

}  // namespace armlet
