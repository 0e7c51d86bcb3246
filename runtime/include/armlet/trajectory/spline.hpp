#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Cubic spline through the points with given speeds at both ends: of all curves through them the
// one with the least integral of squared acceleration, twice continuously differentiable.
//
// t        times of the points, s, ascending from 0; at least two.
// q        positions, as many.
// v_start  speed at the first point; v_end at the last.
// throws   ArgumentError if sizes differ or times do not ascend from 0.
// source   de Boor, A Practical Guide to Splines (1978), chapter IV.
std::vector<Segment> cubic_spline(std::span<const double> t, std::span<const double> q,
                                  double v_start = 0.0, double v_end = 0.0);

}  // namespace armlet
