#pragma once
// The tool pose of a robot as a few coordinates: what the sliders of a laboratory set.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet {

// The present tool pose in these coordinates, m or rad in the world.
[[nodiscard]] std::vector<double> hand_now(const CellRobot& robot, std::span<const HandAxis> axes);

// Joint values for these coordinates of the tool pose: those to which the arm gets from the present
// ones without jumping (drag_tool), otherwise the nearest ones of another solution. Coordinates
// that are not named keep their values; if no angle is named, the orientation is kept as far as the
// arm can.
//
// returns  an error "unreachable" with the reason if there is no solution; `unreached`, if it is
//          not null, then gets the pose at which the tool stops, without time and robot.
[[nodiscard]] Result<Eigen::VectorXd> hand_joints(const CellRobot& robot,
                                                  std::span<const HandAxis> axes,
                                                  std::span<const double> values,
                                                  UnreachedGoal* unreached = nullptr);

// The smallest and the largest value of each coordinate that the arm attains within its limits.
[[nodiscard]] std::vector<std::array<double, 2>> hand_reach(const CellRobot& robot,
                                                            std::span<const HandAxis> axes);

}  // namespace armlet
