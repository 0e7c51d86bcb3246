#include "moves/limit_policy.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/control/tool_goals.hpp"
#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

const Robot& in_cell(Vm& vm, const MoveCall& call) {
  return *Host::of(vm).cell().robot(call.robot).model;
}

// Advice about a value beyond a limit: the joint, the value that is used, and the excess.
Failure advice_about(Vm& vm, const MoveCall& call, MessageCode<4> code, const LimitViolation& v) {
  const JointKind kind = in_cell(vm, call).joint(v.joint).kind;
  Failure advice;
  advice.headline = {code,
                     {std::to_string(v.joint + 1), format_joint_value(kind, v.value, v.limit),
                      format_joint_value(kind, v.excess()), format_joint_value(kind, v.limit)}};
  advice.mark = call.target;
  advice.place = call.place;
  advice.mark_element = call.element;
  return advice;
}

}  // namespace

void advise_clamped(Vm& vm, const MoveCall& call, const std::vector<LimitViolation>& moved) {
  for (const LimitViolation& each : moved) {
    Failure advice = advice_about(vm, call, row("W0757"), each);
    advice.fix = "give it a value inside its limits";
    vm.advise(advice);
  }
}

Eigen::VectorXd clamped(Vm& vm, MoveCall& call, const Eigen::VectorXd& q) {
  const Robot& robot = in_cell(vm, call);
  if (settings_of(vm).limits != LimitCheck::kClamp || q.size() != robot.n() || !q.allFinite())
    return q;
  const std::vector<LimitViolation> outside = limit_violations(robot, q);
  Eigen::VectorXd inside = q;
  for (const LimitViolation& each : outside) inside[each.joint] = each.limit;
  advise_clamped(vm, call, outside);
  if (const LimitViolation* most = farthest(outside); most && most->excess() > call.excess.by)
    call.excess = {most->joint, most->excess()};
  return inside;
}

bool lift_limits(Vm& vm, MoveCall& call) {
  if (settings_of(vm).limits != LimitCheck::kWarn) return false;
  call.model = std::make_shared<const Robot>(with_wider_limits(model_of(vm, call)));
  return true;
}

void advise_beyond(Vm& vm, const MoveCall& call, const std::vector<LimitViolation>& beyond) {
  for (const LimitViolation& each : beyond) {
    Failure advice = advice_about(vm, call, row("W0758"), each);
    advice.why = "a real arm would stop there";
    vm.advise(advice);
  }
}

bool may_be_too_fast(Vm& vm, const MoveCall& call) {
  return MovePolicies{.limits = settings_of(vm).limits, .report_too_fast = call.classic}
      .may_be_too_fast();
}

void advise_lengthened(Vm& vm, const MoveCall& call, const TooFast& fast) {
  Failure advice;
  advice.headline = {row("W0759"),
                     {format_number(fast.given, 6) + " s", format_number(fast.least_time, 3) + " s",
                      std::to_string(fast.joint + 1)}};
  advice.mark = call.time;
  advice.place = call.place;
  vm.advise(advice);
}

std::optional<double> lengthened(Vm& vm, const MoveCall& call, const TooFast& fast) {
  constexpr double kRounding = 1.0 + 1e-9;
  if (settings_of(vm).limits != LimitCheck::kClamp || !std::isfinite(fast.least_time) ||
      fast.least_time <= fast.given)
    return std::nullopt;
  advise_lengthened(vm, call, fast);
  return fast.least_time * kRounding;
}

}  // namespace armlet::bind
