// The fastest motion along a given joint path under limits on speeds and accelerations.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

class Robot;

// The speed along a path: its square at positions of the path parameter. In between the square is
// linear, so the acceleration along the path is constant there.
struct SpeedAlongPath {
  std::vector<double> s{};        // from 0 to the length of the path
  std::vector<double> squared{};  // (ds/dt)^2, 0 at both ends

  [[nodiscard]] double duration() const;
  // The time at which a position is reached, s.
  [[nodiscard]] double time_at(double position) const;
  // The times at which the positions are reached.
  [[nodiscard]] std::vector<double> times() const;
};

// Limits, above zero, on the speed and the acceleration of `travel` between two positions along a
// path.
struct SpeedZone {
  double from = 0.0, to = 0.0;
  double speed = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
};

// The fastest motion from rest to rest along q(s).
//
// path       its "time" is the path parameter s; twice continuously differentiable between its
//            ends, pieces of degree 3 at most. Its derivative at the ends should not be zero.
// limits     speed and acceleration of each joint, finite; jerk is ignored.
// intervals  least number of intervals: positions are at the knots of the path and between them.
//            Limits hold at the positions, on both sides; in between they may be exceeded by a
//            fraction that falls with the square of the number.
// zones      limits along the path itself; they may overlap.
// travel     what the zones limit, as ascending cubic pieces over s: the path of the tool, m.
//            Empty: s itself.
// throws     ArgumentError for a path or limits that violate these conditions.
// source     H. Pham, Q.-C. Pham, A new approach to time-optimal path parameterization based on
//            reachability analysis, T-RO 34(3), 2018; constraints by the interpolation scheme.
SpeedAlongPath fastest_along(const Trajectory& path, std::span<const AxisLimits> limits,
                             int intervals = 100, std::span<const SpeedZone> zones = {},
                             std::span<const Segment> travel = {});

// The motion along the path with this speed, as polynomials of degree 6 in time: s is quadratic in
// t where the acceleration along the path is constant, and q is cubic in s.
//
// throws  ArgumentError for a path of a degree above 3.
// source  J. E. Bobrow, S. Dubowsky, J. S. Gibson, Time-optimal control of robotic manipulators
//         along specified paths, Int. J. Robotics Research 4(3), 1985: motion along a path by s(t).
Trajectory run_along(const Trajectory& path, const SpeedAlongPath& speed);

// A trajectory with its speed along the path.
struct FastestRun {
  SpeedAlongPath speed{};
  Trajectory motion{};
};

// The fastest motion with limits that hold everywhere: it is slowed down between positions where
// limits would be exceeded, until the excess is at most 1e-3 of the time, and then as a whole by
// the rest. Intervals are divided where no limit is reached, since the fastest motion reaches one
// everywhere. Arguments, exceptions and source as for fastest_along.
FastestRun fastest_run(const Trajectory& path, std::span<const AxisLimits> limits,
                       int intervals = 100, std::span<const SpeedZone> zones = {},
                       std::span<const Segment> travel = {});

// The trajectory of fastest_run.
Trajectory time_optimal(const Trajectory& path, std::span<const AxisLimits> limits,
                        int intervals = 100, std::span<const SpeedZone> zones = {});

// The fastest motion that also keeps the force limits of the motors, Joint::max_effort where it is
// finite: by inverse dynamics with friction and with what the arm carries. Joints with an infinite
// acceleration limit are limited by their motors and their speed alone. Viscous friction is bounded
// from above where it opposes the motors, and from below where it helps; the whole motion is slowed
// down until motion_forces finds no force beyond the limits.
//
// returns  nothing if somewhere on the path motors cannot hold the arm, or not move it slowly.
// throws   ArgumentError as fastest_along, and where forces are beyond the range of numbers.
// source   as of fastest_along; J. E. Bobrow, S. Dubowsky, J. S. Gibson, Int. J. Robotics Research
//          4(3), 1985, and K. G. Shin, N. D. McKay, IEEE TAC 30(6), 1985.
std::optional<Trajectory> time_optimal_with_motors(const Robot& robot, const Trajectory& path,
                                                   std::span<const AxisLimits> limits,
                                                   int intervals = 100);

// A path through points whose parameter s grows with the square root of the joint distance between
// them; a cubic spline whose second derivative is zero at its ends.
//
// throws  ArgumentError unless there are at least two points of equal size and neighbours differ.
// source  E. T. Y. Lee, Choosing nodes in parametric curve interpolation, CAD 21(6), 1989.
Trajectory path_through(std::span<const Eigen::VectorXd> points);

}  // namespace armlet
