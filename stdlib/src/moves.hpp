#pragma once
// Starting motions from native calls, and turning what planning says into messages.

#include <optional>
#include <string>

#include "armlet/kinematics/ik.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/cartesian_line.hpp"
#include "armlet/trajectory/verify.hpp"
#include "values.hpp"

namespace armlet::bind {

// Which parameters of a call hold what, for marks; -1: there is none.
struct MoveCall {
  std::string_view function;  // "moveJ"
  int robot = 0;              // in the cell
  int target = 1;
  int time = 2;
  int planner = 5;
  bool classic = false;  // too fast is advice, not an error
};

// What of a target counts for this arm (ruling 14). Empty if its orientation cannot agree with the
// arm at all.
[[nodiscard]] std::optional<IkTask> task_of(const Robot& robot, const PosC& target);

// Joint values for a target, near `seed`; empty: the failure is set.
[[nodiscard]] std::optional<Eigen::VectorXd> solve_target(Vm& vm, const MoveCall& call,
                                                          const PosC& target,
                                                          const Eigen::VectorXd& seed);

// Plans and starts; kPause when the robot is on its way.
Signal move_to_joints(Vm& vm, Slot* args, const MoveCall& call, const Eigen::VectorXd& q,
                      std::string planner, std::optional<double> time, std::optional<double> speed);
Signal move_on_line(Vm& vm, Slot* args, const MoveCall& call, const PosC& target,
                    std::optional<double> time, std::optional<double> speed);

// A robot that another task is moving takes no commands: true, and the failure is set.
[[nodiscard]] bool refuse_busy(Vm& vm, int robot);

// Failures as messages.
Signal fail_unreachable(Vm& vm, const MoveCall& call, const Eigen::Isometry3d& goal,
                        const IkResult& result);
Signal fail_outside(Vm& vm, const MoveCall& call, const Eigen::VectorXd& q,
                    const LimitViolation& outside);
Signal fail_too_fast(Vm& vm, const MoveCall& call, const TooFast& fast);

// Checks a duration: finite and not negative. False: the failure is set.
[[nodiscard]] bool check_duration(Vm& vm, double seconds, int parameter);

}  // namespace armlet::bind
