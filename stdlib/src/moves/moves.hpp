#pragma once
// Starting motions from native calls, and converting results of planning to messages.

#include <memory>
#include <optional>
#include <string>

#include "armlet/control/make_move.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/cartesian_line.hpp"
#include "armlet/trajectory/verify.hpp"
#include "values/robots/robot_state.hpp"
#include "values/settings.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// A running motion, or a substitute for one. When it has ended, it returns a Move, if it returns
// anything.
using Started = Answer<std::unique_ptr<Waiting>>;

inline constexpr std::string_view kStraightLine = "straight line";

// A call that plans or makes a move: what it does, and the arguments that messages mark.
struct MoveCall {
  std::string_view function;  // "moveJ"
  int robot = 0;              // in the cell
  CallPart target = at("target");
  CallPart time = at("time");
  CallPart speed = at("speed");
  CallPart accel = at("accel");
  CallPart planner = at("traj");
  bool classic = false;                  // exceeding speed limits is advice, not an error
  bool fixed_time = false;               // the motion must not be made slower
  bool any_branch = false;               // other solutions for a position in space will do
  bool moves = true;                     // false: the call only asks where a move would lead
  CallPlace place{};                     // of a call that has ended; none: the running one
  int element = -1;                      // of several targets: the index of the one that fails
  std::string_view way = kStraightLine;  // kind of path of the tool
  // The robot with the tool point and the limits of this move; null: the one in the cell.
  std::shared_ptr<const Robot> model{};
  LimitExcess excess{};  // of a target that was clamped
};

// How a move is to be executed, as the call says.
//
// speed, accel  fractions of the joint limits for joint moves, m/s and m/s^2 of the tool point for
//               moves along a line.
// blend         in a path: largest distance from the target at which its corner begins, m.
struct MoveSettings {
  std::optional<double> time{};
  std::optional<double> speed{};
  std::optional<double> accel{};
  std::optional<Eigen::Isometry3d> T_flange_tool{};
  std::optional<Frame> frame{};
  std::optional<double> blend{};
};

// The robot that a call plans with.
[[nodiscard]] const Robot& model_of(Vm& vm, const MoveCall& call);

// The components of a target that count for this arm (language reference, section 13.2). Empty if
// the arm cannot have its orientation for any joint values.
[[nodiscard]] std::optional<IkTask> task_of(const Robot& robot, const PosC& target);

// Joint values for a target in the world, near `seed`.
Answer<Eigen::VectorXd> solve_target(Vm& vm, const MoveCall& call, const PosC& target,
                                     const Eigen::VectorXd& seed);

// Plans and starts a move. Targets are in the frame of the call or of the blocks around it; `near`
// selects a solution; empty: the one nearest to the present joint values.
Started move_to_joints(Vm& vm, MoveCall call, const Eigen::VectorXd& q, std::string planner,
                       const MoveSettings& settings);
Started move_to_position(Vm& vm, MoveCall call, const PosC& target, const Eigen::VectorXd& near,
                         std::string planner, const MoveSettings& settings);
Started move_on_line(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings);
// Over `via`, of which only the position counts.
Started move_on_arc(Vm& vm, MoveCall call, const PosC& via, const PosC& target,
                    const MoveSettings& settings);

// The target in the world: converted from the frame of the call, or of the blocks around it.
Answer<PosC> in_world(Vm& vm, const MoveCall& call, const MoveSettings& settings,
                      const PosC& target);

// Gives the call the robot with the tool point of this move and this fraction of the accelerations.
void choose_model(Vm& vm, MoveCall& call, const MoveSettings& settings, double accel);

// Checks a speed ("a speed", "mm/s") or acceleration of the tool; both of a move.
Answer<void> check_above_zero(Vm& vm, const char* what, double value, const char* unit,
                              CallPart part);
Answer<void> check_tool_rates(Vm& vm, const MoveCall& call, const MoveSettings& settings);

// Checks a fraction of the joint limits.
Answer<void> check_fraction(Vm& vm, const char* what, double value, CallPart part);

// Stops the robot under control; its present move fails with R0618. Ends when the robot is at rest.
std::unique_ptr<Waiting> halt_robot(Vm& vm, int robot);

// A target as the runtime takes it.
[[nodiscard]] inline ToolPose tool_pose(const PosC& target) {
  return {.T_world_tool = target.T, .has_orientation = target.has_orientation};
}

// Failures as messages.
Failed fail_unreachable(Vm& vm, const MoveCall& call, const Eigen::Isometry3d& goal,
                        const IkResult& result);
Failed fail_outside(Vm& vm, const MoveCall& call, const Eigen::VectorXd& q,
                    const LimitViolation& outside);
Failed fail_too_fast(Vm& vm, const MoveCall& call, const TooFast& fast);

// The arm whose motors limit moves in the blocks around the call; null: no block says so.
[[nodiscard]] const Robot* limiting_motors(Vm& vm, const MoveCall& call);

// Checks a duration: finite and not negative.
Answer<void> check_duration(Vm& vm, double seconds, CallPart part);

}  // namespace armlet::bind
