#include "moves/move_waiting.hpp"

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/format_vector.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/motion_collisions.hpp"
#include "moves/move_words.hpp"

namespace armlet::bind {
namespace {

class MoveWaiting : public Waiting {
 public:
  MoveWaiting(Host& host, const MoveCall& call, MoveReport& report)
      : host_(host),
        call_(call),
        function_(call.function),
        motion_(report.motion),
        length_(report.planned.length),
        deviation_(report.planned.deviation),
        excess_(report.limits.excess),
        from_(tool_point()),
        possible_(std::move(report.collisions.possible)) {}

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
      advice.mark = call_.target;
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

// The texts of the parts of a motion, and what a trajectory does not contain.
MotionNotes notes_of(const MoveReport& report, std::vector<std::string> labels) {
  const PlannedMove& planned = report.planned;
  MotionNotes notes{.deviation = planned.deviation, .turn = planned.turn};
  for (std::size_t k = 0; k < labels.size(); ++k) {
    notes.parts.push_back({.what = std::move(labels[k]),
                           .end = planned.times[k],
                           .missed = planned.missed.empty() ? 0.0 : planned.missed[k]});
  }
  return notes;
}

// Of a motion around obstacles; none of other motions.
std::vector<std::string> labels_of(const MoveReport& report) {
  std::vector<std::string> labels;
  if (!report.around) return labels;
  for (const Eigen::Isometry3d& T : report.planned.T_world_targets)
    labels.push_back(fmt::format("around, to {}", format_point_mm(T.translation())));
  return labels;
}

// The call whose target is refused: by default the same with the index of the target.
MoveCall call_of_target(const MoveCall& call, const MoveWords& words, const MoveReport& report) {
  MoveCall at = words.call_of ? words.call_of(report) : call;
  at.model = report.planned.model;
  return at;
}

}  // namespace

Started run_move(Vm& vm, MoveCall call, const MoveCommand& command, const MoveWords& words) {
  Host& host = Host::of(vm);
  MoveReport report = make_move(host.cell(), host.planners(), command);
  call.model = report.planned.model;
  MoveCall timed = words.timed ? *words.timed : call;
  timed.model = call.model;
  advise_planned(vm, call, timed, report);
  advise_checked(vm, call, report);
  if (!report.ok()) {
    const bool is_time = std::holds_alternative<TooFast>(*report.refusal);
    return fail_move(vm, is_time ? timed : call_of_target(call, words, report), report);
  }
  if (report.limits.excess.joint < 0) report.limits.excess = call.excess;
  MotionNotes notes = notes_of(report, words.labels ? words.labels(report) : labels_of(report));
  Trajectory& motion = *report.planned.motion;
  const bool instant = motion.duration() <= 0.0;
  std::unique_ptr<Waiting> waiting = std::make_unique<MoveWaiting>(host, call, report);
  host.remember_motion(call.robot,
                       {std::string(call.function), std::move(motion), std::move(notes)});
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
