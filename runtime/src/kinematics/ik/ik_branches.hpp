#pragma once

#include <vector>

#include "ik_search.hpp"

namespace armlet {

// Finds the solutions that restarts miss, for a goal with isolated solutions: its error has as many
// rows as the arm has joints. Without one row the configurations form curves, and the solutions are
// the zeros of that row on them; solutions close to each other, near a singularity, are on one
// curve. Curves are followed for each row, through the known solutions and from other starts, also
// outside the limits.
//
// solutions  distinct, inside the limits if they apply; new ones are appended.
// source     S. Wampler and A. Sommese, Numerical algebraic geometry and algebraic kinematics, Acta
//            Numerica 20, 2011: the solutions of a system are on the curves of the system with one
//            equation less.
void find_branches(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   std::vector<Eigen::VectorXd>& solutions);

// Whether other solutions may be nearer to the seed than the nearest known one: it is farther away
// than the next singularity, beyond which there may be another one.
bool may_be_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   const Eigen::VectorXd& nearest);

}  // namespace armlet
