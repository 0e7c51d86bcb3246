// The law by which a command for the tool takes up its velocity, and the motion that follows it.
#pragma once

#include <Eigen/QR>
#include <optional>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "trajectory/take_up.hpp"
#include "trajectory/velocity_motion.hpp"

namespace armlet {

// Joint speeds for a velocity of the tool, and what is lacking of it.
struct ToolRates {
  Eigen::VectorXd qd;
  double lacking = 0.0;
};

// A command for the tool. Its speeds are those that give the tool its velocity where the joints
// are, and an error, which dies out along a law that does not depend on where the joints are: so
// the command can be planned again from any state on the motion.
//
// The law is in joint speeds. Where that makes the tool itself too fast, because the joints turn
// far meanwhile, it is in the speeds of the tool: written as joint speeds x at the position `ref`,
// they are those which give the tool the velocity J(ref) x, and the part of x that does not move
// it.
class ToolCommand {
 public:
  // From a state; accelerations are given.
  ToolCommand(const Robot& robot, const VelocityStart& start, const Vector6d& twist)
      : robot_(robot), start_(start), twist_(twist) {
    take_up_.x0 = Eigen::VectorXd::Zero(robot.n());
  }

  // Plans how the error at the start dies out.
  void plan(const ToolLaw& law);

  [[nodiscard]] const Robot& robot() const { return robot_; }
  [[nodiscard]] const VelocityStart& start() const { return start_; }
  [[nodiscard]] const Vector6d& twist() const { return twist_; }
  [[nodiscard]] const ToolLaw& law() const { return law_; }
  [[nodiscard]] const TakeUp& take_up() const { return take_up_; }

  // The joint speeds t seconds after the start, at q.
  [[nodiscard]] ToolRates at(double t, const Eigen::VectorXd& q) const;
  // Their rate of change if the joints move with qd.
  [[nodiscard]] Eigen::VectorXd slope(double t, const Eigen::VectorXd& q,
                                      const Eigen::VectorXd& qd) const;

  // Follows the command until `end`. Nothing, or why the joints cannot.
  //
  // most_qdd  accelerations beyond which it is followed no farther; nothing: however large.
  VelocityPlan follow(double end, VelocityPieces& pieces,
                      const Eigen::VectorXd* most_qdd = nullptr) const;

 private:
  using Solver = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

  static Solver solver_of(const Jacobian& J);
  void refer_to(const Eigen::VectorXd& q);
  [[nodiscard]] Eigen::VectorXd speeds(const Jacobian& J, const Vector6d& v,
                                       const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd speeds(const Eigen::VectorXd& q, const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd bend(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                                     const Eigen::VectorXd& x) const;

  const Robot& robot_;
  const VelocityStart& start_;
  Vector6d twist_;
  ToolLaw law_{};
  Jacobian J_ref_{};
  std::optional<Solver> at_ref_{};
  TakeUp take_up_{};
};

}  // namespace armlet
