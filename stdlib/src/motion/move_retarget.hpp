#pragma once
// Moves of the joints that begin while the robot still slows down after a velocity command.

#include <string_view>

#include "motion/moves.hpp"

namespace armlet::bind {

// Whether this move takes over a robot that slows down: as fast as the joints allow, with the
// planner "Syn" or "SCurve", so that there is a best motion from any state.
[[nodiscard]] bool takes_over(Vm& vm, const MoveCall& call, std::string_view planner,
                              const MoveSettings& settings);

// Goes on from the present speeds to rest at q under limits on speed, acceleration and jerk.
Started move_on_from_speed(Vm& vm, MoveCall call, const Eigen::VectorXd& q, double speed);

}  // namespace armlet::bind
