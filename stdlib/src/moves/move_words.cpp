#include "moves/move_words.hpp"

#include "armlet/core/error.hpp"
#include "armlet/interpreter/virtual_time.hpp"
#include "moves/limit_policy.hpp"
#include "moves/motion_collisions.hpp"
#include "moves/motion_torques.hpp"
#include "moves/move_around.hpp"
#include "moves/move_failures.hpp"
#include "values/bind.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {

MoveCommand command_of(Vm& vm, const MoveCall& call) {
  const BlockSettings block = settings_of(vm);
  return {.robot = call.robot,
          .speed = block.speed,
          .accel = block.accel,
          .T_flange_tool = block.T_flange_tool,
          .policies = {.limits = block.limits,
                       .torques = block.torques,
                       .collisions = block.collisions,
                       .track = block.track,
                       .avoid = block.avoid,
                       .guarded = is_guarded(vm),
                       .report_too_fast = call.classic},
          .time_left = time_left(vm),
          .fixed_time = call.fixed_time};
}

void advise_planned(Vm& vm, const MoveCall& call, const MoveCall& timed, const MoveReport& report) {
  advise_clamped(vm, call, report.limits.clamped);
  for (const TooFast& each : report.limits.lengthened) advise_lengthened(vm, timed, each);
  for (const TooFast& each : report.limits.too_fast) advise_too_fast(vm, timed, each);
  if (!report.around) return;
  Host& host = Host::of(vm);
  host.note_way({.t_ns = host.now_ns(),
                 .robot = call.robot,
                 .model = report.planned.model,
                 .motion = *report.around});
}

namespace {

// Whether the planned motion fits into the time that is left, so that it was checked.
bool is_checked(const MoveReport& report) {
  if (!report.planned.motion) return false;
  const bool is_too_long =
      report.refusal && std::holds_alternative<refused::TooLong>(*report.refusal);
  return !is_too_long || report.torques.slower > 1.0;
}

}  // namespace

void advise_checked(Vm& vm, const MoveCall& call, const MoveReport& report) {
  if (!is_checked(report)) return;
  report_rest(vm, call.robot);
  if (!report.torques.is_refused) static_cast<void>(word_torques(vm, call, report.torques));
  if (report.collisions.is_refused) return;
  for (const CellCollision& each : report.collisions.certain)
    advise_collision(vm, call, each, report.planned.motion->duration());
  advise_beyond(vm, call, report.limits.beyond);
}

namespace {

// One call for each kind of refusal. `call` has the model of the move.
struct RefusalWords {
  Vm& vm;
  const MoveCall& call;
  const MoveReport& report;

  // A check that is repeated for its message.
  static Failed failed(const Answer<void>&) { return {}; }

  Failed operator()(const refused::Busy& why) const { return fail_busy(vm, why.robot); }
  Failed operator()(const refused::NoToolPoint&) const { return failed(check_arm(vm, call.robot)); }
  Failed operator()(const refused::WrongJointCount& why) const {
    return fail_joint_count(vm, call, why.count);
  }
  Failed operator()(const refused::UnknownPlanner& why) const {
    return fail_planner(vm, call, why.name);
  }
  Failed operator()(const refused::BadTime& why) const {
    return failed(check_duration(vm, why.seconds, call.time));
  }
  Failed operator()(const refused::BadRate& why) const {
    switch (why.rate) {
      case refused::Rate::kSpeed:
        return failed(check_fraction(vm, "a speed", why.value, call.speed));
      case refused::Rate::kAcceleration:
        return failed(check_fraction(vm, "an acceleration", why.value, call.accel));
      case refused::Rate::kToolSpeed:
        return failed(check_above_zero(vm, "a speed", why.value, "mm/s", call.speed));
      default:
        return failed(check_above_zero(vm, "an acceleration", why.value, "mm/s^2", call.accel));
    }
  }
  Failed operator()(const refused::TooLong& why) const {
    const CallPart part = why.lasts == refused::Lasts::kTime           ? call.time
                          : why.lasts == refused::Lasts::kSpeed        ? call.speed
                          : why.lasts == refused::Lasts::kAcceleration ? call.accel
                                                                       : CallPart::callee();
    return failed(check_time_left(vm, "a motion", why.seconds, part));
  }
  Failed operator()(const refused::Tilted& why) const {
    return fail_tilted(vm, call, {why.pose.T_world_tool, why.pose.has_orientation});
  }
  Failed operator()(const refused::Unreachable& why) const {
    return fail_unreachable(vm, call, why.T_world_goal, why.ik);
  }
  Failed operator()(const refused::LineBlocked& why) const {
    return fail_line(vm, call, why.q_start, {why.pose.T_world_tool, why.pose.has_orientation},
                     why.fault);
  }
  Failed operator()(const refused::OutsideLimits& why) const {
    if (why.where == refused::Where::kBetween) return fail_swings_outside(vm, call, why.violation);
    return fail_outside(vm, call, why.q, why.violation);
  }
  Failed operator()(const TooFast& why) const { return fail_too_fast(vm, call, why); }
  Failed operator()(const refused::NoTime& why) const {
    return fail_no_time(vm, call, why.distance);
  }
  Failed operator()(const refused::SpeedJumps& why) const {
    return fail_no_ramps(vm, call, why.planner);
  }
  Failed operator()(const refused::StartsElsewhere& why) const {
    return fail_elsewhere(vm, call, why.joint, why.starts, why.stands);
  }
  Failed operator()(const refused::NoWayAround& why) const { return fail_no_way(vm, call, why); }
  Failed operator()(const refused::Collides& why) const {
    return fail_meeting(vm, call, why.met, why.duration);
  }
  Failed operator()(const refused::TorqueExceeded&) const {
    return failed(word_torques(vm, call, report.torques));
  }
  Failed operator()(const refused::Invalid& why) const {
    return failure_of(vm, "R0626", ArgumentError(why.sentence));
  }
};

}  // namespace

Failed fail_move(Vm& vm, const MoveCall& call, const MoveReport& report) {
  return std::visit(RefusalWords{vm, call, report}, *report.refusal);
}

}  // namespace armlet::bind
