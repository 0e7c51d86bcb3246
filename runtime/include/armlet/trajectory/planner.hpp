// Point-to-point planners by name: 'Syn', 'Asyn', 'Lin', 'Cubic', 'Trap', open to registration.
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
struct MoveRequest {
  Eigen::VectorXd q0{};
  Eigen::VectorXd q1{};
  std::vector<AxisLimits> limits{};
  std::optional<double> time{};
  std::optional<double> speed{};
  bool enforce_limits = true;
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

enum class Availability { kAvailable, kNotYet, kUnknown };

// The planners a program can name. All but Lin are described by one law per joint:
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
class PlannerSet {
 public:
  // The five planners above; other names of the language are known but not available yet.
  PlannerSet();

  // Adds a planner, or replaces the one of that name.
  void add(std::string name, Planner planner);

  [[nodiscard]] Availability availability(std::string_view name) const;

  // Names that can be used, in the order in which they were added.
  [[nodiscard]] std::vector<std::string> names() const;

  // Plans with the planner of that name.
  // throws  ArgumentError for a name that is not available, sizes that differ, numbers that are not
  //         finite, a negative time, a speed outside (0, 1], time together with speed.
  [[nodiscard]] Plan plan(std::string_view name, const MoveRequest& request) const;

 private:
  [[nodiscard]] const Planner* find(std::string_view name) const;
  std::vector<std::pair<std::string, Planner>> planners_;
};

}  // namespace armlet
