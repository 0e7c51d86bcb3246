// The fastest motion along a given joint path under limits on speed, acceleration and jerk.
#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/course.hpp"

namespace armlet {

// A motion along a path, and the times at which it reaches positions.
struct TimedRun {
  Trajectory motion{};
  std::vector<double> s{}, t{};  // ascending, from 0 to the length and to the duration
  bool is_fastest = true;        // false: the search for the least duration did not converge

  [[nodiscard]] double time_at(double position) const;
  [[nodiscard]] TimedRun stretched(double factor) const;
};

// A motion from rest to rest along q(s), with continuous accelerations. The squared speed along the
// path is a quadratic spline; an interior point method finds the one of least duration within the
// limits.
//
// path     as for fastest_along.
// limits   speed, acceleration and jerk of each joint, finite.
// fastest  the motion without jerk limits: where it is slow, the spline gets more pieces.
// cells    approximate number of pieces.
// returns  an empty motion if it would take many times as long as the fastest, because joints
//          nearly jump along the path.
// zones    limits on the rate of `travel` and on its rate of change.
// travel   cubic pieces over s, ascending values; empty: s itself.
// source   D. Verscheure and others, Time-optimal path tracking for robots: a convex optimization
//          approach, IEEE TAC 54(10), 2009; the jerk, whose limit is not convex, is linearised in
//          each step such that the limit is kept.
TimedRun smooth_run(const Trajectory& path, std::span<const AxisLimits> limits,
                    const SpeedAlongPath& fastest, int cells, std::span<const SpeedZone> zones = {},
                    std::span<const Segment> travel = {});

// The fastest motion with the limits of motors too. These are kept up to friction and the pieces
// between the tested points, about 1e-3 of them. Joints with an infinite acceleration limit are
// limited by their motors, their speed and their jerk. The path may also begin and end at rest,
// like t^3.
//
// returns  an empty motion also if motors cannot hold the arm somewhere.
TimedRun smooth_run(const Course& course, const SpeedAlongPath& fastest, int cells);

}  // namespace armlet
