#pragma once

#include <vector>

#include "ik_search.hpp"

namespace armlet {

// Looks for the solutions that restarts miss, where a goal has single ones: as many rows of the
// error count as the arm has joints. With one row left out the configurations form curves, and the
// solutions lie where that row is zero as well; solutions close to each other, next to a
// singularity, lie on one curve. Curves are followed for each row, through the solutions known and
// from starts of their own, also outside the limits.
//
// solutions  distinct, inside the limits if they count; those found are added behind them.
// source     S. Wampler and A. Sommese, Numerical algebraic geometry and algebraic kinematics, Acta
//            Numerica 20, 2011: solutions of a system lie on the curves of one with an equation
//            less.
void find_branches(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   std::vector<Eigen::VectorXd>& solutions);

// Whether other solutions may be nearer to the seed than the nearest one known: it is farther away
// than the next singularity is, behind which another one may lie.
bool may_be_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   const Eigen::VectorXd& nearest);

}  // namespace armlet
