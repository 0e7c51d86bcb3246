#include "moves/limit_policy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/angles.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

constexpr double kMoreTurns = 8.0 * kPi;  // rad, beyond the limits of a revolute joint
constexpr double kMoreTravel = 10.0;      // m
constexpr double kAtLimit = 1e-9;         // rad or m, the tolerance with which motions are verified

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
  advice.mark_parameter = call.target;
  advice.place = call.place;
  advice.mark_element = call.element;
  return advice;
}

const LimitViolation* farthest(const std::vector<LimitViolation>& violations) {
  const auto most = std::ranges::max_element(violations, {}, &LimitViolation::excess);
  return most == violations.end() ? nullptr : &*most;
}

}  // namespace

Eigen::VectorXd clamped(Vm& vm, MoveCall& call, const Eigen::VectorXd& q) {
  const Robot& robot = in_cell(vm, call);
  if (settings_of(vm).limits != LimitCheck::kClamp || q.size() != robot.n() || !q.allFinite())
    return q;
  const std::vector<LimitViolation> outside = limit_violations(robot, q);
  Eigen::VectorXd inside = q;
  for (const LimitViolation& each : outside) {
    inside[each.joint] = each.limit;
    Failure advice = advice_about(vm, call, row("W0757"), each);
    advice.fix = "give it a value inside its limits";
    vm.advise(advice);
  }
  if (const LimitViolation* most = farthest(outside); most && most->excess() > call.excess.by)
    call.excess = {most->joint, most->excess()};
  return inside;
}

bool lift_limits(Vm& vm, MoveCall& call, const Eigen::VectorXd& q) {
  if (settings_of(vm).limits != LimitCheck::kWarn) return false;
  const Robot& robot = model_of(vm, call);
  Eigen::VectorXd lower = robot.lower(), upper = robot.upper();
  for (int i = 0; i < robot.n(); ++i) {
    if (robot.joint(i).is_continuous()) continue;
    const double more = robot.is_revolute(i) ? kMoreTurns : kMoreTravel;
    lower[i] -= more;
    upper[i] += more;
    if (q.size() != robot.n() || !std::isfinite(q[i])) continue;
    lower[i] = std::min(lower[i], q[i] - more);
    upper[i] = std::max(upper[i], q[i] + more);
  }
  const Eigen::VectorXd home = robot.home();
  call.model = std::make_shared<const Robot>(robot.with_limits(lower, upper).with_home(home));
  return true;
}

LimitExcess report_excess(Vm& vm, const MoveCall& call, const Trajectory& motion) {
  if (settings_of(vm).limits != LimitCheck::kWarn) return call.excess;
  const Robot& robot = in_cell(vm, call);
  std::vector<LimitViolation> outside;
  for (int i = 0; i < robot.n(); ++i) {
    const Trajectory::Range range = motion.range(i);
    if (range.upper > robot.upper()[i] + kAtLimit)
      outside.push_back({.joint = i, .value = range.upper, .limit = robot.upper()[i]});
    if (range.lower < robot.lower()[i] - kAtLimit)
      outside.push_back({.joint = i, .value = range.lower, .limit = robot.lower()[i]});
  }
  for (const LimitViolation& each : outside) {
    Failure advice = advice_about(vm, call, row("W0758"), each);
    advice.why = "a real arm would stop there";
    vm.advise(advice);
  }
  const LimitViolation* most = farthest(outside);
  return most == nullptr ? call.excess : LimitExcess{most->joint, most->excess()};
}

bool may_be_too_fast(Vm& vm, const MoveCall& call) {
  const LimitCheck limits = settings_of(vm).limits;
  return limits == LimitCheck::kWarn || (call.classic && limits == LimitCheck::kError);
}

std::optional<double> lengthened(Vm& vm, const MoveCall& call, const TooFast& fast) {
  constexpr double kRounding = 1.0 + 1e-9;
  if (settings_of(vm).limits != LimitCheck::kClamp || !std::isfinite(fast.least_time) ||
      fast.least_time <= fast.given)
    return std::nullopt;
  Failure advice;
  advice.headline = {row("W0759"),
                     {format_number(fast.given, 6) + " s", format_number(fast.least_time, 3) + " s",
                      std::to_string(fast.joint + 1)}};
  advice.mark_parameter = call.time;
  advice.place = call.place;
  vm.advise(advice);
  return fast.least_time * kRounding;
}

}  // namespace armlet::bind
