// The fastest run along a given joint path under limits on speeds and accelerations.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

class Robot;

// How fast a path is run: the square of the path speed at positions along it; in between it changes
// linearly, so the acceleration along the path is constant there.
struct SpeedAlongPath {
  std::vector<double> s{};        // from 0 to the length of the path
  std::vector<double> squared{};  // (ds/dt)^2, 0 at both ends

  [[nodiscard]] double duration() const;
  // When a position is reached, s.
  [[nodiscard]] double time_at(double position) const;
  // When each position is reached.
  [[nodiscard]] std::vector<double> times() const;
};

// Between two positions along a path the speed of what travels along it, and how fast that changes,
// is limited; above zero.
struct SpeedZone {
  double from = 0.0, to = 0.0;
  double speed = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
};

// The fastest run from rest to rest along q(s).
//
// path       its "time" is the path parameter s; twice continuously differentiable between its
//            ends, pieces of degree 3 at most. Its derivative at the ends need not be zero, and
//            better is not.
// limits     speed and acceleration of each joint, finite; jerk is not considered.
// intervals  positions are at the knots of the path and between them so that there are at least as
//            many intervals. Limits hold at the positions, on both sides; in between they may be
//            exceeded by a part that falls with the square of the number.
// zones      limits along the path itself; they may overlap.
// travel     what the zones limit, as cubic pieces over s that ascend: the path of the tool, m.
//            Empty: s itself.
// throws     ArgumentError for a path or limits that are not as said.
// source     H. Pham, Q.-C. Pham, A new approach to time-optimal path parameterization based on
//            reachability analysis, T-RO 34(3), 2018; constraints by the interpolation scheme.
SpeedAlongPath fastest_along(const Trajectory& path, std::span<const AxisLimits> limits,
                             int intervals = 100, std::span<const SpeedZone> zones = {},
                             std::span<const Segment> travel = {});

// The motion that runs the path like that, as polynomials of degree 6 in time: s is quadratic in t
// where the acceleration along the path is constant, and q is cubic in s.
//
// throws  ArgumentError for a path of a degree above 3.
// source  J. E. Bobrow, S. Dubowsky, J. S. Gibson, Time-optimal control of robotic manipulators
//         along specified paths, Int. J. Robotics Research 4(3), 1985: motion along a path by s(t).
Trajectory run_along(const Trajectory& path, const SpeedAlongPath& speed);

// A run with its speeds.
struct FastestRun {
  SpeedAlongPath speed{};
  Trajectory motion{};
};

// The fastest run, made slower between places where limits would be exceeded there, until that is
// 1e-3 of the time at most; and then as a whole by what is left, so that they hold everywhere. The
// intervals are divided where no limit is reached, which the fastest run does everywhere.
// Arguments, what is thrown and the source as for fastest_along.
FastestRun fastest_run(const Trajectory& path, std::span<const AxisLimits> limits,
                       int intervals = 100, std::span<const SpeedZone> zones = {},
                       std::span<const Segment> travel = {});

// The motion of fastest_run.
Trajectory time_optimal(const Trajectory& path, std::span<const AxisLimits> limits,
                        int intervals = 100, std::span<const SpeedZone> zones = {});

// The fastest run that also keeps what the motors of an arm give, Joint::max_effort where it is
// finite: by inverse dynamics with friction and with what the arm carries. Joints with an infinite
// limit on acceleration are limited by their motors and their speed alone. Viscous friction is
// taken for at least what it is, and for at most that where it helps; the whole is made slower
// until motion_forces finds nothing beyond the limits.
//
// returns  nothing if motors cannot hold the arm somewhere on the path, or not move it slowly.
// throws   ArgumentError as fastest_along, and where forces are beyond the range of numbers.
// source   as of fastest_along; J. E. Bobrow, S. Dubowsky, J. S. Gibson, Int. J. Robotics Research
//          4(3), 1985, and K. G. Shin, N. D. McKay, IEEE TAC 30(6), 1985.
std::optional<Trajectory> time_optimal_with_motors(const Robot& robot, const Trajectory& path,
                                                   std::span<const AxisLimits> limits,
                                                   int intervals = 100);

// A path through points, with s running like the square root of the joint distance between them;
// a cubic spline whose second derivative is zero at its ends.
//
// throws  ArgumentError unless there are at least two points of equal size, neighbours differing.
// source  E. T. Y. Lee, Choosing nodes in parametric curve interpolation, CAD 21(6), 1989.
Trajectory path_through(std::span<const Eigen::VectorXd> points);

}  // namespace armlet
