// The acceleration parameters of a motion, from which it can be integrated.
#pragma once

#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The acceleration of joint i as polynomials of time, one for each interval between two knots of
// the whole motion: a(t) = sum_k c[k] (t - start)^k. Empty for a motion of no duration.
//
// i       counts from 0.
// returns pieces in rad/s^2 or m/s^2, times in s.
// throws  ArgumentError for a joint that does not exist.
std::vector<Segment> acceleration_pieces(const Trajectory& motion, int i);

}  // namespace armlet
