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

// Cubic spline through the points whose acceleration is zero at both ends; the speeds there are
// free. Arguments as above.
// source  de Boor 1978, chapter IV.
std::vector<Segment> natural_spline(std::span<const double> t, std::span<const double> q);

// Speeds and accelerations prescribed at the two ends of a path.
struct PathEnds {
  double v_start = 0.0;
  double v_end = 0.0;
  double a_start = 0.0;
  double a_end = 0.0;
};

// The functions below take times and positions like cubic_spline, and throw the same exceptions.

// Cubics from point to point. The speed at a point is the mean of the slopes on both sides, zero
// where the direction reverses: there is no overshoot, and a point affects only its neighbours.
// Once continuously differentiable; the accelerations in `ends` are ignored.
// source  L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008,
//         section 4.3.1.
std::vector<Segment> cubic_interpolator(std::span<const double> t, std::span<const double> q,
                                        const PathEnds& ends = {});

// Cubics with a quartic at either end, which has the prescribed acceleration there; twice
// continuously differentiable. Through four points it is the 4-3-4 path. Two points alone are
// joined by two quartics that meet at half the time with equal jerk.
// source  K. S. Fu, R. C. Gonzalez, C. S. G. Lee, Robotics, 1987, section 4.3.
std::vector<Segment> quartic_spline(std::span<const double> t, std::span<const double> q,
                                    const PathEnds& ends = {});

// Quintics, four times continuously differentiable: of all curves through the points with these
// ends the one with the least integral of squared jerk.
// source  C. de Boor, Best approximation properties of spline functions of odd degree, Journal of
//         Mathematics and Mechanics 12, 1963.
std::vector<Segment> quintic_spline(std::span<const double> t, std::span<const double> q,
                                    const PathEnds& ends = {});

// Lift-off, travel and set-down through exactly four points: a cubic, a quintic, a cubic; twice
// continuously differentiable.
// source  Fu, Gonzalez, Lee 1987, section 4.3.
std::vector<Segment> path_353(std::span<const double> t, std::span<const double> q,
                              const PathEnds& ends = {});

// Five cubics through exactly four points, twice continuously differentiable with speed and
// acceleration prescribed at both ends. The first and the last leg are halved; the position where
// the halves meet follows from the conditions.
// source  Fu, Gonzalez, Lee 1987, section 4.3.
std::vector<Segment> path_five_cubics(std::span<const double> t, std::span<const double> q,
                                      const PathEnds& ends = {});

}  // namespace armlet
