// Follows a surface of solutions to the one whose largest joint change is smallest.
#pragma once

#include "kinematics/self_motion/self_motion.hpp"

namespace armlet {

// The largest number of free directions for slide_minimax.
inline constexpr Eigen::Index kMostIdle = 3;

// From q, which meets the goal, moves along the solutions to one nearby with the smallest largest
// change from the seed: a linear program gives each step inside a trust region, and Newton's method
// brings it back to the goal.
//
// source  K. Madsen, An algorithm for minimax solution of overdetermined systems of non-linear
//         equations, J. Inst. Maths Applics 16, 1975; of the linear program, R. Seidel,
//         Small-dimensional linear programming and convex hulls made easy, Discrete &
//         Computational Geometry 6, 1991, with the constraints in their order.
void slide_minimax(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q,
                   double singular);

}  // namespace armlet
