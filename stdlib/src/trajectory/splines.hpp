#pragma once
// Moves of the hand on smooth curves through places.

#include <optional>
#include <string_view>
#include <vector>

#include "armlet/trajectory/cartesian_spline.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// The curve that a planner of that name lays through places; nothing: it knows only joints.
[[nodiscard]] std::optional<SplineKind> spline_called(std::string_view planner);

// Plans and starts. Speeds and accelerations are fractions of the joint limits.
Started move_on_spline(Vm& vm, MoveCall call, const std::vector<PosC>& places, SplineKind kind,
                       const MoveSettings& settings);

}  // namespace armlet::bind
