// Real roots of a polynomial piece, for exact extremes of position, speed and acceleration.
#pragma once

#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Times u in [0, piece.duration], ascending, where the derivative of the given order changes sign.
std::vector<double> sign_changes(const Segment& piece, int order);

}  // namespace armlet
