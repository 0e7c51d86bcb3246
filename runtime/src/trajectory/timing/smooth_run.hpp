// The fastest run along a given joint path under limits on speed, acceleration and jerk.
#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/course.hpp"

namespace armlet {

// A motion along a path, and when positions along it are reached.
struct TimedRun {
  Trajectory motion{};
  std::vector<double> s{}, t{};  // ascending, from 0 to the length and to the duration
  bool is_fastest = true;        // false: the search for the least duration did not converge

  [[nodiscard]] double time_at(double position) const;
  [[nodiscard]] TimedRun stretched(double factor) const;
};

// From rest to rest along q(s), with continuous accelerations. The squared speed along the path is
// a quadratic spline; of those that keep the limits, the one of least duration is found by an
// interior point method.
//
// path     as for fastest_along.
// limits   speed, acceleration and jerk of each joint, finite.
// fastest  the run without limits on jerk: where the path is slow, the spline gets more pieces.
// cells    how many pieces about.
// returns  an empty run if it would take many times as long as the fastest, since joints all but
//          jump along the path.
// zones    limits on the rate of `travel` and on how fast that changes.
// travel   cubic pieces over s, ascending values; empty: s itself.
// source   D. Verscheure and others, Time-optimal path tracking for robots: a convex optimization
//          approach, IEEE TAC 54(10), 2009; the jerk, whose limit is not convex, is taken for what
//          it is to first order in the step, which keeps the limit.
TimedRun smooth_run(const Trajectory& path, std::span<const AxisLimits> limits,
                    const SpeedAlongPath& fastest, int cells, std::span<const SpeedZone> zones = {},
                    std::span<const Segment> travel = {});

// The same with motors too: what they give is kept but for what friction and the pieces between the
// points that are looked at leave, some 1e-3 of it. Joints with an infinite limit on acceleration
// are limited by their motors, their speed and their jerk. The path may also begin and end at rest,
// like t^3.
//
// returns  an empty run also if motors cannot hold the arm somewhere.
TimedRun smooth_run(const Course& course, const SpeedAlongPath& fastest, int cells);

}  // namespace armlet
