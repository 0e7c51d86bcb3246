// Planners of joint motions by name, through two or more points; open to registration.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// From q0 to q1, at rest at both ends.
//
// q0, q1          joint positions, rad and m.
// limits          one per joint.
// time            whole duration, s; nothing: as fast as the limits allow.
// speed           fraction of the limits, above 0 and at most 1: the fastest move, run 1/speed
// times
//                 slower. Not together with time.
// enforce_limits  false: a move that is too fast is planned all the same and only reported.
// via             points between q0 and q1, in order. Planners that know only two points stop at
//                 each.
// durations       s, one per leg; not together with time or speed. Empty: the planner divides.
struct MoveRequest {
  Eigen::VectorXd q0{};
  Eigen::VectorXd q1{};
  std::vector<AxisLimits> limits{};
  std::optional<double> time{};
  std::optional<double> speed{};
  bool enforce_limits = true;
  std::vector<Eigen::VectorXd> via{};
  std::vector<double> durations{};
};

// The asked time is shorter than the move needs. `joint` counts from 0 and is the one that decides.
struct TooFast {
  int joint = 0;
  double given = 0.0;       // s
  double least_time = 0.0;  // s
  double travel = 0.0;      // rad or m, with sign
  LimitKind kind = LimitKind::kSpeed;
  double limit = 0.0;  // the number of that limit
};

// What planning gave.
//
// trajectory  nothing when the move cannot be made as asked.
// too_fast    why there is none; or, where limits are not enforced, the advice that goes with it.
struct Plan {
  std::optional<Trajectory> trajectory{};
  std::optional<TooFast> too_fast{};
};

using Planner = std::function<Plan(const MoveRequest&)>;

// What a planner does with points in between: stops at each (it is called once per leg), or gets
// them all.
enum class Through { kStops, kAllPoints };

// The planners a program can name. Point to point, one law per joint:
//
//   Syn    all joints start and end together; quintic, speed and acceleration zero at both ends.
//   Cubic  the same with a cubic; the acceleration jumps at the ends.
//   Trap   together, trapezoidal speed. With a time: a quarter of it to speed up and to slow down
//   if
//          the limits allow, otherwise ramps at the acceleration limit.
//   Asyn   quintic, every joint at its own limit, stopping when it arrives. With a time, that time
//          belongs to the slowest joint and all joints run at the same fraction of their limits.
//   Lin    one scalar law for all joints, so a straight line in joint space, at constant speed. The
//          ramps at the ends are as short as the acceleration limits allow; a drive cannot jump.
//   Lin0   constant speed from the first moment to the last, for study: no drive can do that.
//   Seq    one joint after another, each with a quintic.
//   Septic, Cycloid  like Syn with those laws; also the jerk is zero at the ends (Septic) or the
//          acceleration is a sine (Cycloid).
//   SCurve limited jerk: every joint as fast as its limits on speed, acceleration and jerk allow,
//          then slowed down to the duration of the slowest.
//
// Through several points, without stopping; from two points where that makes sense:
//
//   Cubic    cubic interpolator: once continuously differentiable, without overshoot.
//   Spline3, Spline4, Spline5  see spline.hpp.
//   434, 353, FiveCubic  lift-off, travel and set-down through four points. From two points the
//          joints lift off and set down by a tenth of the way. Without durations 1:2:1.
//
//   Fastest  a cubic spline in the joints, run as fast as their speeds and accelerations allow
//            everywhere (see time_optimal.hpp); accelerations jump.
//
// These keep their shape in time, so a lower speed or a longer time only slows them down. Without
// durations the legs of the others are divided by how long the slowest joint needs for each.
class PlannerSet {
 public:
  // The planners above.
  PlannerSet();

  // Adds a planner, or replaces the one of that name.
  void add(std::string name, Planner planner, Through through = Through::kStops);

  [[nodiscard]] bool has(std::string_view name) const;

  // Names that can be used, in the order in which they were added.
  [[nodiscard]] std::vector<std::string> names() const;

  // Plans with the planner of that name.
  // throws  ArgumentError for a name that is not available, sizes that differ, numbers that are not
  //         finite, a negative time, a speed outside (0, 1], time together with speed.
  [[nodiscard]] Plan plan(std::string_view name, const MoveRequest& request) const;

 private:
  struct Entry {
    std::string name;
    Planner plan;
    Through through;
  };
  [[nodiscard]] const Entry* find(std::string_view name) const;
  std::vector<Entry> planners_;
};

}  // namespace armlet
