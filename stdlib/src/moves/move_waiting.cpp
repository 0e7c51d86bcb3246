#include "moves/move_waiting.hpp"

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/limit_policy.hpp"
#include "moves/motion_collisions.hpp"
#include "moves/motion_torques.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {
namespace {

class MoveWaiting : public Waiting {
 public:
  MoveWaiting(Host& host, const MoveCall& call, int motion, double length, double deviation,
              LimitExcess excess, std::vector<PossibleCollision> possible)
      : host_(host),
        call_(call),
        function_(call.function),
        motion_(motion),
        length_(length),
        deviation_(deviation),
        excess_(excess),
        from_(tool_point()),
        possible_(std::move(possible)) {}

  [[nodiscard]] std::int64_t due_ns() const override { return host_.cell().known_until(motion_); }
  [[nodiscard]] bool is_over() const override { return report().state != MotionState::kRunning; }
  void stop() override {
    if (!is_over()) host_.cell().stop(call_.robot);
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("{} of {}", function_, arm().name);
  }
  [[nodiscard]] Resource resource() const override { return robot_called(arm().name); }

  Signal finish(Vm& vm, Slot& result) override {
    const MotionReport& done = report();
    const bool reached = done.state == MotionState::kReached;
    const double duration = to_seconds(done.end_ns - done.start_ns);
    host_.report_move({arm().name, function_, to_seconds(done.start_ns), duration, !reached,
                       host_.cell().T_world_tool(call_.robot)});
    report_events(vm);
    report_collisions(vm, call_, motion_, possible_);
    if (done.halted) return fail_halted(vm);
    if (!check_presses(vm, call_, done)) return Signal::kFail;
    RecordObj* move = new_record(vm, vm.program().library_record("Move"));
    if (move == nullptr) return Signal::kFail;
    move->fields()[0] = slot_of(reached);
    move->fields()[1] = slot_of(!reached);
    move->fields()[2] = slot_of(duration);
    move->fields()[3] = slot_of(reached ? length_ : (tool_point() - from_).norm());
    move->fields()[4] = slot_of(deviation_);
    move->fields()[5].i = excess_.joint + 1;
    move->fields()[6] = slot_of(excess_.by);
    result.o = move;
    return Signal::kDone;
  }

 private:
  [[nodiscard]] const MotionReport& report() const { return host_.cell().report(motion_); }
  [[nodiscard]] const CellRobot& arm() const { return host_.cell().robot(call_.robot); }
  [[nodiscard]] Eigen::Vector3d tool_point() const {
    const Robot& model = call_.model != nullptr ? *call_.model : *arm().model;
    return forward(model, arm().q).translation();
  }

  Signal fail_halted(Vm& vm) {
    Failure f;
    f.headline = Headline(row("R0618"));
    f.resource = resource();
    f.moved = report().end_ns > report().start_ns;
    return fail(vm, std::move(f));
  }

  // A pick by contact is reported once.
  void report_events(Vm& vm) {
    for (const CellEvent& event : host_.take_events()) {
      if (event.kind == CellEventKind::kSlipped) advise_slip(vm, event);
      if (event.kind != CellEventKind::kPicked || !host_.first_contact_pick()) continue;
      Failure advice;
      advice.headline = {row("W0704"), {event.object}};
      advice.mark_parameter = call_.target;
      advice.why =
          "this program never calls grasp or release, so objects named in insertObj are picked up "
          "and put down by contact";
      advice.fix = "call grasp and release to decide yourself";
      vm.advise(advice);
    }
  }

  Host& host_;
  MoveCall call_;
  std::string function_;
  int motion_;
  double length_;
  double deviation_;
  LimitExcess excess_;
  Eigen::Vector3d from_;
  std::vector<PossibleCollision> possible_;
};

class NoMove : public Waiting {
 public:
  [[nodiscard]] std::int64_t due_ns() const override { return 0; }
  [[nodiscard]] bool is_over() const override { return true; }
  void stop() override {}
  Signal finish(Vm& vm, Slot& result) override {
    return give(&result, new_record(vm, vm.program().library_record("Move")));
  }
  [[nodiscard]] std::string what() const override { return "move"; }
};

// Waits until a robot that was halted is at rest.
class HaltWaiting : public Waiting {
 public:
  HaltWaiting(Cell& cell, int robot)
      : cell_(cell), robot_(robot), motion_(cell.robot(robot).motion_id) {}

  [[nodiscard]] std::int64_t due_ns() const override { return cell_.report(motion_).end_ns; }
  [[nodiscard]] bool is_over() const override {
    return !cell_.is_moving(robot_) || cell_.report(motion_).state != MotionState::kRunning;
  }
  void stop() override {}
  Signal finish(Vm&, Slot&) override { return Signal::kDone; }
  [[nodiscard]] std::string what() const override {
    return fmt::format("halt of {}", cell_.robot(robot_).name);
  }

 private:
  Cell& cell_;
  int robot_;
  int motion_;
};

}  // namespace

Started start_motion(Vm& vm, const MoveCall& call, Trajectory trajectory, double length,
                     MotionNotes notes) {
  Host& host = Host::of(vm);
  if (!check_time_left(vm, "a motion", trajectory.duration(), kMarkCallee)) return Failed{};
  report_rest(vm, call.robot);
  const auto slower = check_torques(vm, call, trajectory);
  if (!slower) return Failed{};
  if (*slower > 1.0) {
    trajectory = trajectory.stretched(*slower);
    for (MotionPart& part : notes.parts) part.end *= *slower;
    if (!check_time_left(vm, "a motion", trajectory.duration(), kMarkCallee)) return Failed{};
  }
  auto possible = check_collisions(vm, call, trajectory);
  if (!possible) return Failed{};
  const bool instant = trajectory.duration() <= 0.0;
  const double deviation = notes.deviation;
  const LimitExcess excess = report_excess(vm, call, trajectory);
  host.remember_motion(call.robot, {std::string(call.function), trajectory, std::move(notes)});
  const int motion = host.cell().is_moving(call.robot)
                         ? host.cell().drive(call.robot, std::move(trajectory))
                         : host.cell().start(call.robot, std::move(trajectory));
  std::unique_ptr<Waiting> waiting = std::make_unique<MoveWaiting>(
      host, call, motion, length, deviation, excess, *std::move(possible));
  if (instant) host.advance_to(host.now_ns());
  return waiting;
}

std::unique_ptr<Waiting> no_move() { return std::make_unique<NoMove>(); }

std::unique_ptr<Waiting> halt_robot(Vm& vm, int robot) {
  Cell& cell = Host::of(vm).cell();
  if (cell.is_moving(robot)) cell.halt(robot);
  return std::make_unique<HaltWaiting>(cell, robot);
}

}  // namespace armlet::bind
