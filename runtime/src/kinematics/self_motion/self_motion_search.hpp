#pragma once

#include <vector>

#include "kinematics/ik/ik_numeric.hpp"

namespace armlet {

// Searches a curve of configurations that reach the goal, given by points along it, for the
// solution inside the limits that is nearest to the seed. Between two points a joint lies between
// its values at both, and beyond them by no more than it bends; pieces that leave room for
// something nearer are halved, the most promising first.
//
// returns whether there is one nearer than `change`, which then replaces q and `change`.
bool search_curve(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                  const std::vector<JointArray>& curve, JointArray& q, double& change);

}  // namespace armlet
