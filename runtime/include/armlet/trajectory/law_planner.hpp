// Planners made from one scalar law, for users who provide their own.
#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/planner.hpp"

namespace armlet {

// A scalar law s(x) for x from 0 to 1 as consecutive polynomials; s(0) = 0 and s(1) = 1.
using ScalarLaw = std::vector<Segment>;

// The polynomial sum_k c[k] x^k, of degree 7 at most.
//
// throws  ArgumentError unless s(0) = 0 and s(1) = 1 (within 1e-9).
ScalarLaw law_of_polynomial(std::span<const double> c);

// The law through values at evenly spaced x, the first at 0 and the last at 1: a cubic spline. Its
// slopes at each end follow from the six nearest values, 0 if they are below 1e-4. Cubic laws are
// reproduced exactly.
//
// source  C. de Boor, A Practical Guide to Splines, 1978, chapter IV.
// throws  ArgumentError for fewer than six values, values that are not finite, and ends as above.
ScalarLaw law_of_values(std::span<const double> s);

// All joints move together along q0 + s(t / T) (q1 - q0). Without a time T is as short as the
// limits allow: the largest of max|s'| D / V, sqrt(max|s''| D / A) and, where s'' is continuous and
// zero at both ends, cbrt(max|s'''| D / J). Where s'' jumps no duration limits the jerk, as for the
// planners Cubic and Trap; jumps of up to 2 % of max|s''| count as errors of a law given by values.
//
// law     as made by the functions above.
// source  L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008,
//         chapter 5 (scaling in time).
Planner planner_of_law(ScalarLaw law);

}  // namespace armlet
