#pragma once
// The hand of a robot by a few coordinates: what the sliders of a laboratory set.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet {

// Where the hand is now, by these coordinates, m or rad in the world.
[[nodiscard]] std::vector<double> hand_now(const CellRobot& robot, std::span<const HandAxis> axes);

// Joint values that bring the hand there, as near as possible to those of now; coordinates that are
// not named stay as they are, an orientation of which none is named as far as the arm can keep it.
//
// returns  an error "unreachable" that says why there are none; `unreached`, if it is given, is
//          then what comes nearest, without time and robot.
[[nodiscard]] Result<Eigen::VectorXd> hand_joints(const CellRobot& robot,
                                                  std::span<const HandAxis> axes,
                                                  std::span<const double> values,
                                                  UnreachedGoal* unreached = nullptr);

// The smallest and the largest value of each that the arm can have anywhere in its reach.
[[nodiscard]] std::vector<std::array<double, 2>> hand_reach(const CellRobot& robot,
                                                            std::span<const HandAxis> axes);

}  // namespace armlet
