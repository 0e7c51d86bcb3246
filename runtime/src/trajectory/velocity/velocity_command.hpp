// The law by which a command for the tool reaches its velocity, and the motion that follows it.
#pragma once

#include <optional>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "math/solvers.hpp"
#include "trajectory/velocity/take_up.hpp"
#include "trajectory/velocity/velocity_motion.hpp"

namespace armlet {

// Joint speeds for a velocity of the tool, and the missing part of that velocity.
struct ToolRates {
  Eigen::VectorXd qd;
  double lacking = 0.0;
};

// Limits at which following a command ends.
//
// qdd   largest accelerations, rad/s^2 or m/s^2.
// most  largest speeds of the tool.
// calm  fraction by which the tool may exceed them.
struct FollowLimits {
  Eigen::VectorXd qdd;
  ToolSpeeds most;
  double calm = 0.0;
};

// The fraction by which a velocity of the tool exceeds the largest speeds.
double excess_of(const Vector6d& twist, const ToolSpeeds& most);

// A command for the tool. Its joint speeds are the sum of those that give the tool its velocity at
// the present joint values, and an error, which decays along a law that does not depend on the
// joint values: so the command can be continued from any state on the motion.
//
// The law is in joint speeds. If that makes the tool itself too fast, because the joints move far
// meanwhile, the law is in the speeds of the tool. Written as joint speeds x at the joint values
// `ref`, these are the ones that give the tool the velocity J(ref) x, plus the part of x that does
// not move it. If the arm comes to rest through a singular position, the tool direction that is
// nearly lost at `ref` is left to the joints: in the joint direction that moves fast for it, their
// speed is that of x, so that it need not be brought to rest before the singular position.
class ToolCommand {
 public:
  // Begins in the state of `from`, with its acceleration; the error decays along `law`.
  ToolCommand(const Robot& robot, const VelocityStart& from, const Vector6d& twist,
              const ToolLaw& law);

  [[nodiscard]] const Robot& robot() const { return robot_; }
  [[nodiscard]] const TakeUp& take_up() const { return take_up_; }

  // The joint speeds t seconds after the beginning, at q.
  [[nodiscard]] ToolRates at(double t, const Eigen::VectorXd& q) const;
  // The rate of change of these joint speeds if the joints move with qd.
  [[nodiscard]] Eigen::VectorXd slope(double t, const Eigen::VectorXd& q,
                                      const Eigen::VectorXd& qd) const;

  // Follows the command from a time after its beginning, at which `pieces` ends, to a later one.
  // The result has no motion, or the reason why the joints cannot.
  //
  // limits  at which following ends; null: none.
  VelocityPlan follow(double begin, double end, VelocityPieces& pieces,
                      const FollowLimits* limits = nullptr) const;

 private:
  [[nodiscard]] Jacobian rows(const Jacobian& J) const;
  [[nodiscard]] Eigen::VectorXd speeds(const Jacobian& J_tool, const Vector6d& v,
                                       const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd speeds(const Eigen::VectorXd& q, const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd bend(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                                     const Eigen::VectorXd& x) const;

  const Robot& robot_;
  Vector6d twist_;
  ToolLaw law_;
  Eigen::VectorXd q_start_;
  Vector6d lost_ = Vector6d::Zero();  // direction of the tool
  Eigen::VectorXd idle_{};            // and the joint direction that moves it there
  Jacobian J_ref_{};
  std::optional<OrthogonalFactors> at_ref_{};
  TakeUp take_up_{};
};

}  // namespace armlet
