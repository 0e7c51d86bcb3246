#pragma once

#include <vector>

#include "kinematics/ik/ik_numeric.hpp"

namespace armlet {

// The self-motion of an arm with one joint more than the goal needs, or at a goal where it is
// singular: the configurations that reach a goal form curves. Revolute joints count modulo whole
// revolutions, so most curves are closed; joint limits cut pieces out of them.

using JointDirections =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;

// Largest motion of the tool, m or rad per rad or m, in a free direction; and at a singular goal,
// where the iterations find solutions less exactly.
inline constexpr double kIdleTool = 1e-6;
inline constexpr double kNearlyIdleTool = 1e-3;

// Orthonormal directions, as columns, in which the joints move without changing the rows of the
// task.
//
// rank_tolerance  m or rad per rad or m that the tool may move.
JointDirections idle_directions(const Robot& robot, const IkGoal& goal, const JointArray& q,
                                double rank_tolerance);

// The curves on which a goal has been followed, and their solution nearest to the seed.
class SelfMotions {
 public:
  SelfMotions(const Robot& robot, const IkGoal& goal, const IkOptions& options);

  // The set that is connected with a solution: only itself, a curve, or another one.
  enum class Found { kAlone, kCurve, kOther };

  // Follows the curve through a solution, unless it is known.
  Found follow(const JointArray& q);

  // Searches the curves that were followed since the last call for a solution inside the limits
  // that is nearer than `change`. Returns whether there is one, which replaces q.
  bool bring_nearer(JointArray& q, double& change);

  // Follows the curves beyond the singularities that the known curves come near to: those with the
  // other elbow or wrist branch.
  void follow_neighbours();

  bool empty() const { return curves_.empty(); }

  // In the order in which they were found; points along each.
  using Curve = std::vector<JointArray>;
  const std::vector<Curve>& curves() const { return curves_; }

 private:
  double difference(std::size_t i, double a, double b) const;
  double distance_to(const JointArray& a, const JointArray& b, const JointArray& q,
                     double& share) const;
  bool is_known(const JointArray& q);
  bool slides_away(const JointArray& q) const;
  bool step(const JointArray& from, JointArray& along, double length, JointArray& to);
  bool walk(const JointArray& from, const JointArray& first, Curve& curve);

  double regularity(const JointArray& q) const;
  bool mirror(const JointArray& q, JointArray& other);

  const Robot& robot_;
  const IkGoal& goal_;
  const IkOptions& options_;
  std::size_t n_;
  std::array<bool, kMaxJoints> turns_{};
  IkSolver solver_;
  std::vector<Curve> curves_;
  std::size_t searched_ = 0, mirrored_ = 0;  // number of curves
};

}  // namespace armlet
