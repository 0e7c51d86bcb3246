// Planners of joint motions by name, through two or more points; further planners can be added.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

class Robot;

// A request for a motion from q0 to q1, at rest at both ends.
//
// q0, q1          joint positions, rad and m.
// limits          one per joint.
// time            whole duration, s; nothing: as fast as the limits allow.
// speed           fraction of the speed limit of every joint, above 0 and at most 1; limits on
//                 acceleration and jerk are unchanged. Not together with time. PlannerSet::plan
//                 multiplies the limits by it, so planners never receive it.
// enforce_limits  false: a move that is too fast is planned all the same and only reported.
// via             points between q0 and q1, in order. Planners for two points stop at each.
// durations       s, one per leg; not together with time or speed. Empty: the planner divides the
//                 time.
// motors          the arm, with what it carries. For Fastest and SCurve the force limits of its
//                 motors replace the acceleration limits of joints whose Joint::max_effort is
//                 finite; null: no such limits. Other planners do not read it.
struct MoveRequest {
  Eigen::VectorXd q0{};
  Eigen::VectorXd q1{};
  std::vector<AxisLimits> limits{};
  std::optional<double> time{};
  std::optional<double> speed{};
  bool enforce_limits = true;
  std::vector<Eigen::VectorXd> via{};
  std::vector<double> durations{};
  const Robot* motors = nullptr;
};

// The requested time is shorter than the move needs. `joint`, from 0, is the one that needs most.
struct TooFast {
  int joint = 0;
  double given = 0.0;       // s
  double least_time = 0.0;  // s
  double travel = 0.0;      // rad or m, with sign
  LimitKind kind = LimitKind::kSpeed;
  double limit = 0.0;  // the number of that limit
};

// The result of planning.
//
// trajectory  nothing when the requested move is impossible.
// too_fast    the reason; or, where limits are not enforced, advice about the trajectory.
struct Plan {
  std::optional<Trajectory> trajectory{};
  std::optional<TooFast> too_fast{};
};

using Planner = std::function<Plan(const MoveRequest&)>;

// How a planner treats points in between: it stops at each (and is called once per leg), or it gets
// all of them.
enum class Through { kStops, kAllPoints };

enum class SplineKind;  // cartesian_spline.hpp

// A planner that programs can name: one row of runtime/src/trajectory/planners/planner.cpp, in the
// order in which messages and documents list them.
struct PlannerRow {
  std::string_view name;
  std::string_view does;  // how the joints move, as a part of a sentence
  Plan (*plan)(const MoveRequest&) = nullptr;
  Through through = Through::kStops;
  int smooth = 0;  // how many derivatives of the positions are continuous, from rest to rest
  std::optional<SplineKind> in_space{};  // the curve of the same name through poses of the tool
};
[[nodiscard]] std::span<const PlannerRow> planner_rows();

// Planners by name; their laws and sources are in profile.hpp, spline.hpp, jerk_limited.hpp and
// time_optimal.hpp. For planners through several points whose path is independent of the duration,
// lower limits or a longer time only slow the motion down. For the others, without durations, the
// time is divided among the legs as the slowest joint needs it for each.
class PlannerSet {
 public:
  // The planners of planner_rows().
  PlannerSet();

  // Adds a planner, or replaces the one of that name. What the planner throws, plan() throws.
  void add(std::string name, Planner planner, Through through = Through::kStops);

  [[nodiscard]] bool has(std::string_view name) const;

  // Names of the planners, in the order in which they were added.
  [[nodiscard]] std::vector<std::string> names() const;

  // Plans with the planner of that name.
  // throws  ArgumentError for a name that does not exist, sizes that differ, numbers that are not
  //         finite, a negative time, a speed outside (0, 1], time together with speed.
  [[nodiscard]] Plan plan(std::string_view name, const MoveRequest& request) const;

 private:
  struct Entry {
    std::string name;
    Planner plan;
    Through through;
  };
  using Entries = std::vector<Entry>;
  [[nodiscard]] static std::shared_ptr<const Entries> built_in();
  [[nodiscard]] const Entry* find(std::string_view name) const;
  std::shared_ptr<const Entries> planners_;  // shared by all sets to which no planner was added
};

}  // namespace armlet
