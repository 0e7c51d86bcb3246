#pragma once

#include "ik_closed.hpp"

namespace armlet {

// The goal of the iterations for a task.
IkGoal make_goal(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                 const IkOptions& options);

// The solver of a result that is the seed itself.
inline constexpr std::string_view kStands = "the robot stands there";

// The result of the restarts.
struct IkSearch {
  std::vector<Eigen::VectorXd> solutions;  // distinct, in the order in which they were found
  Eigen::VectorXd closest;                 // the best configuration if there is no solution
  IkError closest_error;
  int iterations = 0;
  int starts = 0;
};

// Restarts from the seed and then from evenly spread configurations.
//
// wanted        stop after this number of distinct solutions.
// extra_starts  stop after this number of starts from the first solution on.
IkSearch search_ik(const Robot& robot, const IkGoal& goal, const IkOptions& options, int wanted,
                   int extra_starts);

// Solutions that the iterations find inside the limits, starting at and around the seed; none
// without limits.
void search_near(const Robot& robot, const IkGoal& goal, const IkOptions& options, int starts,
                 std::vector<Eigen::VectorXd>& solutions);

// Two solutions are one if no joint differs by more, rad or m.
inline constexpr double kSameSolution = 1e-4;

// Whether none of the solutions is q, revolute joints counting modulo a revolution.
bool is_new(const Robot& robot, const std::vector<Eigen::VectorXd>& solutions,
            const Eigen::VectorXd& q, double same = kSameSolution);

// Moves every revolute joint to the copy nearest to the seed, within the limits if they apply.
// Adding and removing whole revolutions must not move a joint at its limit beyond it by rounding.
//
// beyond  rad, by which a copy may exceed a limit.
void wrap_to_seed(const Robot& robot, const IkOptions& options, JointArray& q,
                  double beyond = 1e-9);

// The largest change of one joint between two configurations.
double largest_change(const Eigen::VectorXd& q_1, const Eigen::VectorXd& q_2);

// Sorts solutions by the largest change from the seed; within 1e-9 the positive elbow comes first,
// then the one found first.
void sort_by_nearness(const Robot& robot, const Eigen::VectorXd& seed,
                      std::vector<Eigen::VectorXd>& solutions);

// Element `index` of the sequence of starts within `change` of the seed, and inside the limits if
// they apply.
JointArray start_within(const Robot& robot, const IkOptions& options, double change, int index);

// Improves the solutions of the iterations: follows curves and surfaces of solutions, divides
// shared angles anew, and sorts them. The first is then as near to the seed as any on the
// self-motions that are reached from them, and from starts near the seed.
void bring_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                  std::vector<Eigen::VectorXd>& solutions);

// The first of at least one branch in that order.
const FormulaSolution& nearest_branch(const Robot& robot, const Eigen::VectorXd& seed,
                                      const std::vector<FormulaSolution>& branches);

// Replaces a solution by the one with the best posture, as the options ask for.
void take_best_posture(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                       const IkGoal& goal, const IkOptions& options, IkResult& result);

// Fills status and diagnosis of a result for which no solution was found.
//
// returns  true if the search for the nearest pose found that it is the goal after all.
bool diagnose(const Robot& robot, const IkGoal& goal, const IkOptions& options, IkResult& result);

}  // namespace armlet
