#include "moves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "bind.hpp"
#include "move_failures.hpp"

namespace armlet::bind {
namespace {

constexpr double kUprightTolerance = 1e-6;

// Whether the tool axis always stays parallel to the world's z axis: all joints turn about it or
// slide along it.
bool keeps_tilt(const Robot& robot) {
  const Chain& chain = robot.chain();
  for (int i = 1; i < robot.n(); ++i) {
    if (std::abs(chain.sin_alpha[i]) > 0.0) return false;
  }
  return std::abs(std::abs(robot.T_world_base().linear()(2, 2)) - 1.0) < kUprightTolerance &&
         chain.sin_alpha[0] == 0.0;
}

// A motion from its start to its end, and the Move it gives.
class MoveWaiting : public Waiting {
 public:
  MoveWaiting(Host& host, const MoveCall& call, int motion, double length)
      : host_(host),
        function_(call.function),
        target_(call.target),
        robot_(call.robot),
        motion_(motion),
        length_(length) {}

  [[nodiscard]] std::int64_t due_ns() const override { return report().end_ns; }
  [[nodiscard]] bool is_over() const override { return report().state != MotionState::kRunning; }
  void stop() override {
    if (!is_over()) host_.cell().stop(robot_);
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("{} of {}", function_, robot());
  }
  [[nodiscard]] std::string robot() const override { return host_.cell().robot(robot_).name; }

  Signal finish(Vm& vm, Slot& result) override {
    const MotionReport& done = report();
    const bool reached = done.state == MotionState::kReached;
    const double duration = to_seconds(done.end_ns - done.start_ns);
    host_.report_move({host_.cell().robot(robot_).name, function_, to_seconds(done.start_ns),
                       duration, !reached, host_.cell().T_world_tool(robot_)});
    tell_events(vm);
    RecordObj* move = new_record(vm, vm.program().library_record("Move"));
    if (move == nullptr) return Signal::kFail;
    move->fields()[0] = slot_of(reached);
    move->fields()[1] = slot_of(!reached);
    move->fields()[2] = slot_of(duration);
    move->fields()[3] = slot_of(length_);
    result.o = move;
    return Signal::kDone;
  }

 private:
  [[nodiscard]] const MotionReport& report() const { return host_.cell().report(motion_); }

  // Contact picking says once that it happened.
  void tell_events(Vm& vm) {
    for (const CellEvent& event : host_.take_events()) {
      if (event.kind != CellEventKind::kPicked || !host_.first_contact_pick()) continue;
      Failure advice;
      advice.code = "W0704";
      advice.arguments = {event.object};
      advice.mark_parameter = target_;
      advice.why =
          "this program never calls grasp or release, so objects named in insertObj are picked up "
          "and put down by contact";
      advice.fix = "call grasp and release to decide yourself";
      vm.advise(advice);
    }
  }

  Host& host_;
  std::string function_;
  int target_;
  int robot_;
  int motion_;
  double length_;
};

Signal start(Vm& vm, Slot* args, const MoveCall& call, Trajectory trajectory, double length) {
  Host& host = Host::of(vm);
  const bool instant = trajectory.duration() <= 0.0;
  const int motion = host.cell().start(call.robot, std::move(trajectory));
  auto waiting = std::make_unique<MoveWaiting>(host, call, motion, length);
  if (!instant) return pause(vm, std::move(waiting));
  host.advance_to(host.now_ns());
  return waiting->finish(vm, args[0]);
}

}  // namespace

bool refuse_busy(Vm& vm, int robot_id) {
  const CellRobot& robot = Host::of(vm).cell().robot(robot_id);
  if (!robot.motion) return false;
  Failure f;
  f.code = "R0617";
  f.arguments = {robot.name};
  f.mark_parameter = kMarkCallee;
  f.robot = robot.name;
  f.fix = "wait until its move has ended";
  static_cast<void>(fail(vm, std::move(f)));
  return true;
}

bool check_duration(Vm& vm, double seconds, int parameter) {
  if (std::isfinite(seconds) && seconds >= 0.0) return true;
  if (!std::isfinite(seconds)) {
    static_cast<void>(not_finite(vm, "the time", seconds, parameter));
  } else {
    static_cast<void>(failure(
        vm, "R0609", fmt::format("a move cannot take {} s", format_number(seconds)), parameter,
        "time only runs forwards", "use a time of 0 s or more, or leave it out"));
  }
  return false;
}

std::optional<IkTask> task_of(const Robot& robot, const PosC& target) {
  if (!target.has_orientation) return IkTask::kPlace;
  if (!keeps_tilt(robot)) return IkTask::kPose;
  if (std::abs(std::abs(target.T.linear()(2, 2)) - 1.0) > kUprightTolerance) return std::nullopt;
  return IkTask::kTurn;
}

std::optional<Eigen::VectorXd> solve_target(Vm& vm, const MoveCall& call, const PosC& target,
                                            const Eigen::VectorXd& seed) {
  const Robot& robot = *Host::of(vm).cell().robot(call.robot).model;
  const std::optional<IkTask> task = task_of(robot, target);
  if (!task) {
    static_cast<void>(fail_tilted(vm, call, target));
    return std::nullopt;
  }
  IkOptions options;
  options.seed = seed;
  options.task = *task;
  IkResult result = solve_ik(robot, target.T, options);
  if (!result.ok()) {
    static_cast<void>(fail_unreachable(vm, call, target.T, result));
    return std::nullopt;
  }
  return std::move(result.q);
}

Signal move_to_joints(Vm& vm, Slot* args, const MoveCall& call, const Eigen::VectorXd& q,
                      std::string planner, std::optional<double> time,
                      std::optional<double> speed) {
  Host& host = Host::of(vm);
  const CellRobot& state = host.cell().robot(call.robot);
  const Robot& robot = *state.model;
  if (refuse_busy(vm, call.robot)) return Signal::kFail;
  if (q.size() != robot.n()) return fail_joint_count(vm, call, static_cast<int>(q.size()));
  if (time && !check_duration(vm, *time, call.time)) return Signal::kFail;
  if (speed && !(*speed > 0.0 && *speed <= 1.0)) {
    return failure(
        vm, "R0609",
        fmt::format("a speed of {}: a fraction of the joint limits lies above 0 and not above 1",
                    format_number(*speed)),
        call.time + 1);
  }
  if (host.planners().availability(planner) != Availability::kAvailable)
    return fail_planner(vm, call, planner);
  const JointMove move{.q0 = state.q,
                       .q1 = q,
                       .planner = std::move(planner),
                       .time = time,
                       .speed = speed,
                       .enforce_limits = !call.classic};
  MotionPlan plan = plan_joint_move(host.planners(), robot, move);
  if (!plan.outside.empty()) return fail_outside(vm, call, q, plan.outside.front());
  if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
  if (plan.too_fast) advise_too_fast(vm, call, *plan.too_fast);
  const Eigen::Vector3d from = host.cell().T_world_tool(call.robot).translation();
  const Eigen::Vector3d to = forward(robot, q).translation();
  return start(vm, args, call, *std::move(plan.trajectory), (to - from).norm());
}

Signal move_on_line(Vm& vm, Slot* args, const MoveCall& call, const PosC& target,
                    std::optional<double> time, std::optional<double> speed) {
  Host& host = Host::of(vm);
  const CellRobot& state = host.cell().robot(call.robot);
  const Robot& robot = *state.model;
  if (refuse_busy(vm, call.robot)) return Signal::kFail;
  if (time && !check_duration(vm, *time, call.time)) return Signal::kFail;
  if (speed && !(std::isfinite(*speed) && *speed > 0.0)) {
    return failure(vm, "R0609",
                   fmt::format("a speed of {} mm/s: the hand needs a speed above 0",
                               format_number(*speed * 1000.0)),
                   call.time + 1);
  }
  const std::optional<IkTask> task = task_of(robot, target);
  if (!task) return fail_tilted(vm, call, target);
  const double distance =
      (target.T.translation() - host.cell().T_world_tool(call.robot).translation()).norm();
  if (time && *time == 0.0 && distance > 0.0) {
    return fail_no_time(vm, call, distance);
  }
  LineMove move{.q0 = state.q,
                .T_world_goal = target.T,
                .task = *task,
                .time = time,
                .tool_speed = speed,
                .enforce_limits = !call.classic};
  LinePlan plan = plan_line(robot, move);
  if (plan.fault) return fail_line(vm, call, target, *plan.fault);
  if (!plan.motion.outside.empty())
    return fail_outside(vm, call, state.q, plan.motion.outside.front());
  if (!plan.motion.trajectory) return fail_too_fast(vm, call, *plan.motion.too_fast);
  if (plan.motion.too_fast) advise_too_fast(vm, call, *plan.motion.too_fast);
  return start(vm, args, call, *std::move(plan.motion.trajectory), plan.length);
}

}  // namespace armlet::bind
