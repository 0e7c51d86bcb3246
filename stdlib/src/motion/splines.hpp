#pragma once
// Moves of the tool on smooth curves through poses.

#include <optional>
#include <string_view>
#include <vector>

#include "armlet/trajectory/cartesian_spline.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The curve through poses of a planner with that name; nullopt: the planner knows only joints.
[[nodiscard]] std::optional<SplineKind> spline_called(std::string_view planner);

// Plans and starts the move. Speeds and accelerations are fractions of the joint limits.
Started move_on_spline(Vm& vm, MoveCall call, const std::vector<PosC>& places, SplineKind kind,
                       const MoveSettings& settings);

}  // namespace armlet::bind
