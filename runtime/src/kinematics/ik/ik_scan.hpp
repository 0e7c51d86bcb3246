#pragma once

#include <vector>

#include "ik_closed.hpp"

namespace armlet {

// The arm angle, or the held joint, of an arm of seven joints.
inline constexpr int kArmAngle = -1;

// Over all values of a joint that the goal leaves open, or of the arm angle: of each branch the
// solution whose largest change from the seed is smallest.
//
// near          what the other open joints keep; the value of this one comes first, and of equals
//               it wins.
// nearest_only  only the nearest of all has to be exact.
std::vector<FormulaSolution> scan_open_joint(const Robot& robot, const IkGoal& goal,
                                             const IkOptions& options, int joint,
                                             const Eigen::VectorXd& near, bool nearest_only);

}  // namespace armlet
