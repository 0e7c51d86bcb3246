#pragma once

#include <optional>
#include <vector>

#include "kinematics/ik/ik_numeric.hpp"

namespace armlet {

// Where an arm is nearly singular, the equations of a goal reduce to one: the others are met along
// a curve, and what is left of the goal is a height in the direction of the tool that is all but
// lost. Solutions are its zeros. They come in pairs that all but coincide, with the elbow next to
// stretched, or lie half a revolution of a wrist apart in between of which hardly anything is left
// of the goal; the iterations tell neither apart.
//
// points     along the curve, as far as little is left of the goal.
// solutions  on it, exactly; of two that all but coincide the one midway between them.
// is_idle    whether the goal is met all along the curve; there are no single solutions then.
struct ReducedCurve {
  std::vector<JointArray> points{};
  std::vector<JointArray> solutions{};
  bool is_idle = true;
};

// The curve through joint values next to a solution; none if the arm is not nearly singular there.
// As many rows of the goal count as the arm has joints.
//
// source  A. Griewank, G. W. Reddien, Characterization and computation of generalized turning
//         points, SIAM Journal on Numerical Analysis 21(1), 1984: the equation that is left, and
//         its slope, from bordered systems.
std::optional<ReducedCurve> reduced_curve(const Robot& robot, const IkGoal& goal,
                                          const JointArray& q);

}  // namespace armlet
