#pragma once

#include <vector>

#include "ik_closed.hpp"

namespace armlet {

// Stands for the arm angle, or the held joint, of an arm of seven joints.
inline constexpr int kArmAngle = -1;

// Scans all values of an open joint, or of the arm angle: for each branch the solution whose
// largest change from the seed is smallest.
//
// near          values of the other open joints; its value of the scanned joint comes first, and
//               wins between equal costs.
// nearest_only  only the nearest of all has to be exact.
std::vector<FormulaSolution> scan_open_joint(const Robot& robot, const IkGoal& goal,
                                             const IkOptions& options, int joint,
                                             const Eigen::VectorXd& near, bool nearest_only);

}  // namespace armlet
