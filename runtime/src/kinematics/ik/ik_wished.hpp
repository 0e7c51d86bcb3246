// The solution nearest to desired joint values among those that are connected.
#pragma once

#include "ik_numeric.hpp"

namespace armlet {

// Desired joint values of a redundant arm, with distances relative to the joint ranges.
//
// q      n values, rad or m.
// range  of each joint, at least 0; a joint with range 0 does not move.
struct WishedJoints {
  Eigen::VectorXd q;
  Eigen::VectorXd range;

  // Half the sum of squared deviations from q, in ranges.
  [[nodiscard]] double cost(const JointArray& at) const;
};

// From q, which meets the goal within finite limits, moves along the solutions to one nearby of
// least cost. Each step leads to the point of the tangent plane within the limits that is nearest
// to the desired values, and Newton's method brings it back to the goal. q meets the goal
// afterwards too.
//
// source  J. Nocedal, S. J. Wright, Numerical Optimization, 2nd edition, 2006, 15.2 and 18.5
//         (elimination of equality constraints, trust regions); the model ignores the curvature of
//         the solutions, for which the trust region compensates.
void slide_to_wished(const Robot& robot, IkSolver& solver, const WishedJoints& wished,
                     JointArray& q);

}  // namespace armlet
