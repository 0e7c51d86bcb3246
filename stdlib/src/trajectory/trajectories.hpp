#pragma once
// Trajectories as values (language reference, sections 13.2 and 19), and planning through points.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"
#include "values/values.hpp"

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

}  // namespace armlet::bind

namespace armlet {

// Functions take and give what a trajectory holds.
template <>
struct Argument<const bind::PlannedMotion&> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, &bind::kTrajectory};
  static const bind::PlannedMotion& read(Vm&, Slot slot) {
    return *host_value<bind::TrajectoryValue>(slot).plan;
  }
};
template <>
struct Given<bind::PlannedMotion> {
  static constexpr ValueKind kKind = Argument<const bind::PlannedMotion&>::kKind;
  static Signal leave(Vm& vm, bind::PlannedMotion plan, Slot& slot) {
    auto kept = std::make_shared<const bind::PlannedMotion>(std::move(plan));
    return give(&slot, new_host_value(vm, bind::kTrajectory, bind::TrajectoryValue{kept}));
  }
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

// A motion of the robot through all points, planned and verified.
Answer<Trajectory> plan_through(Vm& vm, MoveCall call, const std::vector<Eigen::VectorXd>& points,
                                const std::string& planner, const PointSettings& settings);

// Along straight lines of the tool point from place to place, standing still at each. `start` are
// the joints at the first place.
Answer<Trajectory> plan_lines(Vm& vm, MoveCall call, const Eigen::VectorXd& start,
                              const std::vector<PosC>& places, const PointSettings& settings);

// The joints of every posJ of a list, checked for their number.
Answer<std::vector<Eigen::VectorXd>> joint_points(Vm& vm, MoveCall& call,
                                                  const HostList<PosJ>& list);
// The same for positions in the world: each as near as can be to the one before, the first to
// `seed`.
Answer<std::vector<Eigen::VectorXd>> solved_points(Vm& vm, const MoveCall& call,
                                                   const std::vector<PosC>& places,
                                                   Eigen::VectorXd seed);
// The positions of a list as the world sees them.
Answer<std::vector<PosC>> positions_in_world(Vm& vm, const MoveCall& call,
                                             const MoveSettings& settings,
                                             const HostList<PosC>& list);

// How far the tool point gets, straight from the start to the end of a motion, m.
[[nodiscard]] double path_between_ends(Vm& vm, const MoveCall& call, const Trajectory& motion);

// A trajectory that can be given to this robot, where it stands.
Answer<void> check_follows(Vm& vm, const MoveCall& call, const PlannedMotion& plan);

}  // namespace armlet::bind
