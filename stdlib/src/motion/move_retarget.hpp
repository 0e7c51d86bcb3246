#pragma once
// Moves of the joints that begin while the robot still decelerates after a velocity command.

#include <string_view>

#include "motion/moves.hpp"

namespace armlet::bind {

// Whether this move continues from the present speeds of the robot: only moves as fast as the
// joints allow, with the planner "Syn" or "SCurve", for which an optimum exists from any state.
[[nodiscard]] bool takes_over(Vm& vm, const MoveCall& call, std::string_view planner,
                              const MoveSettings& settings);

// Moves from the present speeds to rest at q within limits on speed, acceleration and jerk.
Started move_on_from_speed(Vm& vm, MoveCall call, const Eigen::VectorXd& q, double speed);

}  // namespace armlet::bind
