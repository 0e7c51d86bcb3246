#pragma once
// Trajectories as values (language reference, sections 13.2 and 19), and planning through points.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"
#include "moves.hpp"
#include "values.hpp"

namespace armlet::bind {

// A motion that was planned and verified, and what it says when it is printed.
struct PlannedMotion {
  std::string planner;
  Trajectory motion;
  PosJ joints;                         // their number and kinds
  std::shared_ptr<const Robot> robot;  // whose limits it was planned for
};
// What a `trajectory` of the language holds; it never changes, so copies share it.
struct TrajectoryValue {
  std::shared_ptr<const PlannedMotion> plan;
};

[[nodiscard]] inline const PlannedMotion& planned(Slot s) {
  return *host_value<TrajectoryValue>(s).plan;
}
[[nodiscard]] Obj* new_trajectory(Vm& vm, PlannedMotion plan);
}  // namespace armlet::bind

namespace armlet {
template <>
struct Argument<const bind::PlannedMotion&> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, &bind::kTrajectory};
  static const bind::PlannedMotion& read(Vm&, Slot slot) { return bind::planned(slot); }
};
}  // namespace armlet

namespace armlet::bind {

// How points are to be joined.
//
// durations  parameter of the call that holds them; the list is empty if there are none.
struct PointSettings {
  MoveSettings move{};
  std::vector<double> durations{};
  int durations_parameter = -1;
};

// A motion of the robot through all points, planned and verified. Empty: the failure is set.
[[nodiscard]] std::optional<Trajectory> plan_through(Vm& vm, MoveCall call,
                                                     const std::vector<Eigen::VectorXd>& points,
                                                     const std::string& planner,
                                                     const PointSettings& settings);

// Along straight lines of the tool point from place to place, standing still at each. `start` are
// the joints at the first place.
[[nodiscard]] std::optional<Trajectory> plan_lines(Vm& vm, MoveCall call,
                                                   const Eigen::VectorXd& start,
                                                   const std::vector<PosC>& places,
                                                   const PointSettings& settings);

// The joints of every posJ of a list, checked for their number. Empty: the failure is set.
[[nodiscard]] std::optional<std::vector<Eigen::VectorXd>> joint_points(Vm& vm, const MoveCall& call,
                                                                       Slot list);
// The same for places in the world: each as near as can be to the one before, the first to `seed`.
[[nodiscard]] std::optional<std::vector<Eigen::VectorXd>> solved_points(
    Vm& vm, const MoveCall& call, const std::vector<PosC>& places, Eigen::VectorXd seed);
// The places of a list as the world sees them. Empty: the failure is set.
[[nodiscard]] std::optional<std::vector<PosC>> places_in_world(Vm& vm, const MoveCall& call,
                                                               const MoveSettings& settings,
                                                               Slot list);

// How far the tool point gets, straight from the start to the end of a motion, m.
[[nodiscard]] double way_between_ends(Vm& vm, const MoveCall& call, const Trajectory& motion);

// A trajectory that can be given to this robot, where it stands. False: the failure is set.
[[nodiscard]] bool check_follows(Vm& vm, const MoveCall& call, const PlannedMotion& plan);

}  // namespace armlet::bind
