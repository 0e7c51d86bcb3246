#include "armlet/dynamics/identification.hpp"

#include <numbers>
#include <utility>

#include "armlet/core/random.hpp"
#include "dynamics/checks.hpp"
#include "dynamics/coupled.hpp"
#include "dynamics/plan_dynamics.hpp"
#include "dynamics/spatial_arm.hpp"
#include "dynamics/trees/follower_forces.hpp"
#include "link_parameters.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Random motions in all configurations, at all speeds, and some at rest: there gravity acts without
// dry friction. While a joint moves, the friction of both directions and a constant force are
// linearly dependent.
class RandomMotions {
 public:
  explicit RandomMotions(const Robot& robot) : robot_(robot) {}

  MatrixXd next() {
    const Index n = robot_.n();
    VectorXd q(n), qd(n), qdd(n);
    for (Index i = 0; i < n; ++i) {
      const bool slides = robot_.joint(static_cast<int>(i)).kind == JointKind::kPrismatic;
      const double reach = slides ? 1.0 : std::numbers::pi;
      q[i] = random_.uniform(-reach, reach);
      qd[i] = random_.uniform(-2.0, 2.0);
      qdd[i] = random_.uniform(-5.0, 5.0);
    }
    if (++made_ % kRests == 0) qd.setZero();
    return dynamics_regressor(robot_, q, qd, qdd);
  }

 private:
  static constexpr int kRests = 4;  // one motion of this many is at rest
  const Robot& robot_;
  Random random_{1991};
  int made_ = 0;
};

// An orthonormal basis of a sequence of columns, by the Gram-Schmidt process with each projection
// applied twice.
// source  G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013, section 5.2.
class ColumnBasis {
 public:
  explicit ColumnBasis(Index rows, Index most) : Q_(rows, most), R_(MatrixXd::Zero(most, most)) {}

  // Adds a column, of length 1, if it is linearly independent of the earlier ones. Otherwise it is
  // their sum with `factors`.
  bool take(const VectorXd& column, VectorXd& factors) {
    constexpr double kIndependent = 1e-7;  // of the length that remains after projection
    const auto Q = Q_.leftCols(size_);
    VectorXd along = Q.transpose() * column;
    VectorXd left = column - Q * along;
    const VectorXd more = Q.transpose() * left;
    left -= Q * more;
    along += more;
    const double length = left.norm();
    if (length > kIndependent) {
      Q_.col(size_) = left / length;
      R_.col(size_).head(size_) = along;
      R_(size_, size_) = length;
      ++size_;
      return true;
    }
    factors = std::move(along);
    for (Index i = size_; i-- > 0;) {  // R factors = along
      factors[i] /= R_(i, i);
      factors.head(i) -= factors[i] * R_.col(i).head(i);
    }
    return false;
  }

 private:
  MatrixXd Q_, R_;
  Index size_ = 0;
};

// For an arm with independent rows, without links outside of the chain.
MatrixXd regressor_of_chain(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd) {
  const SpatialArm arm(robot, q);
  MatrixXd Y = MatrixXd::Zero(robot.n(), kLinkParameters * robot.n());
  Vector6d velocity = Vector6d::Zero(), acceleration = arm.base_acceleration;
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const Vector6d& axis = arm.axis[at];
    acceleration += axis * qdd[i] + spatial_cross(velocity, axis) * qd[i];
    velocity += axis * qd[i];
    const Eigen::Isometry3d T_base_link = arm.frame[at] * link_in_joint(robot, i);
    const Index first = kLinkParameters * i;
    for (int k = 0; k < kMassParameters; ++k) {
      const Matrix6d I = spatial_inertia(unit_body(k).seen_from(T_base_link));
      const Vector6d force = I * acceleration + spatial_cross_force(velocity, I * velocity);
      for (int j = 0; j <= i; ++j)
        Y(j, first + k) = arm.axis[static_cast<std::size_t>(j)].dot(force);
    }
    Y(i, first + kMassParameters) = qdd[i];
    Y(i, first + kMassParameters + 1) = qd[i];
    if (qd[i] != 0.0) Y(i, first + kMassParameters + (qd[i] > 0.0 ? 2 : 3)) = 1.0;
  }
  return Y;
}

}  // namespace

VectorXd dynamic_parameters(const Robot& robot) {
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  VectorXd p(kLinkParameters * robot.rows());
  for (int i = 0; i < robot.rows(); ++i) {
    const PlanLink& link = plan.links[i];
    p.segment<kLinkParameters>(kLinkParameters * i) << mass_parameters(moments_in_link(robot, i)),
        link.motor_inertia, link.friction.viscous, link.friction.coulomb_plus,
        link.friction.coulomb_minus;
  }
  if (!has_followers(robot)) return p;
  const VectorXd more = follower_parameters(robot);
  p.conservativeResize(p.size() + more.size());
  p.tail(more.size()) = more;
  return p;
}

MatrixXd dynamics_regressor(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd) {
  check_joint_values("q", q, robot);
  check_joint_values("qd", qd, robot);
  check_joint_values("qdd", qdd, robot);
  const JointCoupling* coupling = robot.coupling();
  MatrixXd Y = coupling == nullptr
                   ? regressor_of_chain(robot, q, qd, qdd)
                   : MatrixXd(coupling->E.transpose() *
                              regressor_of_chain(coupling->rows, coupling->values(q),
                                                 coupling->rates(qd), coupling->rates(qdd)));
  if (has_followers(robot)) {
    const MatrixXd more = follower_regressor(robot, q, qd, qdd);
    Y.conservativeResize(Eigen::NoChange, Y.cols() + more.cols());
    Y.rightCols(more.cols()) = more;
  }
  check_finite("regressor", Y);
  return Y;
}

BaseParameters base_parameters(const Robot& robot) {
  const Index n = robot.n(), parameters = dynamic_parameters(robot).size();
  const Index links = parameters / kLinkParameters;  // including those outside of the arm
  const Index motions = 3 * kLinkParameters * ((links + n - 1) / n);
  RandomMotions random(robot);
  MatrixXd W(motions * n, parameters);
  for (Index k = 0; k < motions; ++k) W.middleRows(k * n, n) = random.next();

  BaseParameters base;
  ColumnBasis basis(W.rows(), parameters);
  MatrixXd grouping = MatrixXd::Zero(parameters, parameters);  // its first rows
  VectorXd lengths(parameters), factors;                       // of the independent columns
  const double largest = W.colwise().norm().maxCoeff();
  for (Index c = 0; c < parameters; ++c) {
    const double length = W.col(c).norm();
    if (length <= 1e-12 * largest) continue;  // it has no effect at all
    const Index taken = static_cast<Index>(base.columns.size());
    if (basis.take(W.col(c) / length, factors)) {
      grouping(taken, c) = 1.0;
      lengths[taken] = length;
      base.columns.push_back(static_cast<int>(c));
    } else {
      grouping.col(c).head(taken) = factors.array() * length / lengths.head(taken).array();
    }
  }
  base.grouping = grouping.topRows(static_cast<Index>(base.columns.size()));
  check_finite("grouping of parameters", base.grouping);
  return base;
}

}  // namespace armlet
