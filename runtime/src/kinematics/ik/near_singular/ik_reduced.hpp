#pragma once

#include <optional>
#include <vector>

#include "kinematics/ik/ik_numeric.hpp"

namespace armlet {

// Near a singular position the equations of a goal reduce to one: the others are satisfied along a
// curve, and the remaining error is a height in the direction in which the tool nearly cannot move.
// Solutions are the zeros of the height. They come in pairs that nearly coincide (the elbow nearly
// stretched), or are half a revolution of a wrist apart with hardly any error between them; the
// iterations cannot separate them in either case.
//
// points     along the curve, as far as the remaining error is small.
// solutions  on it, exactly; of two that nearly coincide the one midway between them.
// is_idle    whether the goal is met all along the curve; then there are no isolated solutions.
struct ReducedCurve {
  std::vector<JointArray> points{};
  std::vector<JointArray> solutions{};
  bool is_idle = true;
};

// The curve through joint values near a solution; none if the arm is not nearly singular there. The
// task has as many rows as the arm has joints.
//
// source  A. Griewank, G. W. Reddien, Characterization and computation of generalized turning
//         points, SIAM Journal on Numerical Analysis 21(1), 1984: the reduced equation, and its
//         slope, from bordered systems.
std::optional<ReducedCurve> reduced_curve(const Robot& robot, const IkGoal& goal,
                                          const JointArray& q);

}  // namespace armlet
