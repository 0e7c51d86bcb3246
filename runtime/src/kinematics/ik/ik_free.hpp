#pragma once

#include "ik_numeric.hpp"

namespace armlet {

// Joints about one line, or prismatic joints along parallel lines, only determine the sum of their
// values: it can be divided between them without moving the tool. If the task is a position, a
// joint about the tool point is free by itself.

// Moves each joint to the copy nearest to the seed, and distributes angles that joints share so
// that the largest change from the seed is smallest, within the limits if the options say so.
//
// shares   whether to look for joints that share an angle.
// returns  the largest amount by which a joint exceeds its limits; 0 if none does. If it is more
//          than rounding, joints may be unchanged.
double bring_near(const Robot& robot, const IkGoal& goal, const IkOptions& options, bool shares,
                  JointArray& q);

// The largest change of one joint.
double change_of(const JointArray& q, const Eigen::VectorXd& seed);

// A joint that exceeds a limit by at most this, rad or m, counts as on it.
inline constexpr double kLimitSlack = 1e-7;

// The smallest change of joint i to a value between low and high, or whole revolutions from there,
// inside the limits; infinite if there is none.
double change_within(const Robot& robot, const IkOptions& options, std::size_t i, double low,
                     double high);

// If there are infinitely many solutions, follows those connected with q to one that is nearer to
// the seed. q meets the goal before and after.
//
// singular  m or rad that the tool may move per rad or m of a free direction.
// returns   whether there were several free directions at once.
bool slide_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q,
                  double singular = 1e-6);

}  // namespace armlet
