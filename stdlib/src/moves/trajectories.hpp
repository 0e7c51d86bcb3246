#pragma once
// Trajectories as values (language reference, sections 13.2 and 19), and planning through points.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"
#include "moves/moves.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// A motion that was planned and verified, and the text that is shown when it is printed.
struct PlannedMotion {
  std::string planner;
  Trajectory motion;
  PosJ joints;                         // number and kinds of the joints
  std::shared_ptr<const Robot> robot;  // the robot with the limits used for planning
};
// The value of a `trajectory` of the language; it never changes, so copies share it.
struct TrajectoryValue {
  std::shared_ptr<const PlannedMotion> plan;
};

}  // namespace armlet::bind

namespace armlet {

// Functions take and return the motion in a TrajectoryValue.
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

// How points are joined.
//
// durations  s, one per segment; empty if the call gives none.
struct PointSettings {
  MoveSettings move{};
  std::vector<double> durations{};
};

// A motion of the robot through all points, planned and verified.
Answer<Trajectory> plan_through(Vm& vm, MoveCall call, const std::vector<Eigen::VectorXd>& points,
                                const std::string& planner, const PointSettings& settings);

// A motion on straight lines of the tool point from pose to pose, with a stop at each. `start` are
// the joint values at the first pose.
Answer<Trajectory> plan_lines(Vm& vm, MoveCall call, const Eigen::VectorXd& start,
                              const std::vector<PosC>& places, const PointSettings& settings);

// The joint values of every posJ of a list, checked for their number.
Answer<std::vector<Eigen::VectorXd>> joint_points(Vm& vm, MoveCall& call,
                                                  const HostList<PosJ>& list);
// The joint values for poses in the world: for each the solution nearest to the one before, for the
// first the one nearest to `seed`.
Answer<std::vector<Eigen::VectorXd>> solved_points(Vm& vm, const MoveCall& call,
                                                   const std::vector<PosC>& places,
                                                   Eigen::VectorXd seed);
// The poses of a list, converted to the world.
Answer<std::vector<PosC>> positions_in_world(Vm& vm, const MoveCall& call,
                                             const MoveSettings& settings,
                                             const HostList<PosC>& list);

}  // namespace armlet::bind
