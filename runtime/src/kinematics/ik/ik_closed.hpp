#pragma once

#include <vector>

#include "armlet/kinematics/closed_form.hpp"
#include "ik_numeric.hpp"

namespace armlet {

// The answer of the closed form for a goal.
//
// kSilent  the arm has none, or it gives no answer.
// kSome    a joint is free, so there may be more solutions than those found.
// kAll     there are no other solutions.
// kNone    there are no solutions.
enum class FormulaAnswer { kSilent, kSome, kAll, kNone };

// A solution of the closed form within the goal's tolerances and the limits, each revolute joint at
// the copy nearest to the seed.
struct FormulaSolution {
  JointArray q{};
  int branch = 0;
};

// Whether the closed form of the arm solves this kind of task.
bool formula_applies(const Robot& robot, const IkGoal& goal, const IkOptions& options);

// All solutions, in the order of the closed form; the seed determines what the goal leaves free.
//
// arm_angle_change  added to the seed's arm angle, of an arm of seven joints.
// nearest_only      where the goal leaves freedom, only the nearest solution has to be exact;
//                   solutions of other branches may be missing or farther away.
FormulaAnswer solve_by_formula(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                               std::vector<FormulaSolution>& solutions,
                               double arm_angle_change = 0.0, bool nearest_only = false);

// The same for an arm of seven joints at the first arm angle with solutions, counted from the
// seed's.
std::vector<FormulaSolution> solve_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                   const IkOptions& options);

// For each branch the solution nearest to the seed at any arm angle, the nearest of them first.
std::vector<FormulaSolution> nearest_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                     const IkOptions& options);

}  // namespace armlet
