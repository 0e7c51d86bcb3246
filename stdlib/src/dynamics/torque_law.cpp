#include "dynamics/torque_law.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {
namespace {

std::string_view name_of(SimulationEventKind kind) {
  constexpr std::string_view kNames[] = {"stop", "stick", "slip"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace

TorqueLaw::TorqueLaw(Vm& vm, FunctionValue law) : vm_(vm), law_(law.object) { retain(law_); }

TorqueLaw::TorqueLaw(TorqueLaw&& other) noexcept
    : vm_(other.vm_),
      law_(std::exchange(other.law_, nullptr)),
      q_(std::exchange(other.q_, {})),
      qd_(std::exchange(other.qd_, {})) {}

TorqueLaw::~TorqueLaw() {
  for (Obj* object : {law_, static_cast<Obj*>(q_.list), static_cast<Obj*>(qd_.list)}) {
    if (object != nullptr) release(vm_, object);
  }
}

ListObj* TorqueLaw::fill(Argument& argument, JointsIn values) {
  ListObj*& list = argument.list;
  if (list == nullptr || list->refs != 1) {  // the program may have stored the last one
    if (list != nullptr) release(vm_, list);
    list = new_list(vm_, static_cast<std::uint32_t>(values.size()), false);
  }
  for (Eigen::Index i = 0; list != nullptr && i < values.size(); ++i) list->data[i].d = values[i];
  return list;
}

Answer<JointVector> TorqueLaw::operator()(const Robot& robot, double t, JointsIn q, JointsIn qd) {
  ListObj* const positions = fill(q_, q);
  ListObj* const rates = positions != nullptr ? fill(qd_, qd) : nullptr;
  if (rates == nullptr) return Failed{};
  const Slot arguments[] = {slot_of(t), slot_of(positions), slot_of(rates)};
  Slot result;
  if (!vm_.call(law_, arguments, result)) return Failed{};
  const std::span<const double> values = reals_value(result);
  const std::size_t count = values.size();
  JointVector tau = JointVector::Zero(robot.n());
  if (count == static_cast<std::size_t>(robot.n())) std::ranges::copy(values, tau.begin());
  release(vm_, result.o);
  if (count != static_cast<std::size_t>(robot.n())) {
    return failure(vm_, "R0613",
                   fmt::format("the torques are {} values for the {} joints of `{}`, at {:.6g} s",
                               count, robot.n(), robot.name(), t),
                   at("law"), "the function gives what every motor gives, in N m or N");
  }
  for (int i = 0; i < robot.n(); ++i) {
    if (std::isfinite(tau[i])) continue;
    return failure(vm_, "R0612",
                   fmt::format("the torque of joint {} is {} at {:.6g} s", i + 1,
                               std::isnan(tau[i]) ? "not a number" : "infinite", t),
                   at("law"));
  }
  return tau;
}

Answer<SimulationOptions> simulation_options(Vm& vm, const SimulationCall& call) {
  const auto positive = [&](double seconds, CallPart part) -> Answer<void> {
    if (!std::isfinite(seconds)) return not_finite(vm, "a time", seconds, part);
    if (seconds > 0.0) return {};
    return domain_failure(vm, fmt::format("{} for a time", call.function), seconds,
                          "be longer than 0 s", {}, part);
  };
  if (!positive(call.during, at("during")) || !positive(call.every, at("every"))) return Failed{};
  SimulationOptions options;
  options.step = call.step.value_or(std::min(1e-3, call.every));
  if (!positive(options.step, at("step"))) return Failed{};
  const auto method = ode_method(call.method);
  if (!method) {
    std::string names;
    for (const std::string_view known : ode_method_names())
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known);
    return failure(vm, "R0609",
                   fmt::format("there is no method \"{}\" to integrate with", call.method),
                   at("method"), "the methods are " + names);
  }
  options.method = *method;
  options.restitution = call.restitution;
  if (!(call.restitution >= 0.0 && call.restitution <= 1.0)) {
    return domain_failure(vm, "a restitution", call.restitution, "lie between 0 and 1", {},
                          at("restitution"));
  }
  return options;
}

MotorLimits::MotorLimits(const Robot& robot) : most_(robot.n()) {
  for (int i = 0; i < robot.n(); ++i) most_[i] = robot.joint(i).max_effort;
}

Answer<void> MotorLimits::take(Vm& vm, std::span<const double> values, std::string_view what,
                               CallPart part, JointVector& limits) const {
  if (static_cast<Eigen::Index>(values.size()) != most_.size()) {
    return failure(vm, "R0613",
                   fmt::format("{} are {} values for an arm of {} joint{}", what, values.size(),
                               most_.size(), most_.size() == 1 ? "" : "s"),
                   part);
  }
  limits = Eigen::Map<const Eigen::VectorXd>(values.data(), most_.size());
  for (const double limit : values) {
    if (!(limit > 0.0))
      return domain_failure(vm, fmt::format("one of {}", what), limit, "be above 0", {}, part);
  }
  return {};
}

Answer<void> MotorLimits::set_most(Vm& vm, std::span<const double> most, CallPart part) {
  return take(vm, most, "the largest torques", part, most_);
}

Answer<void> MotorLimits::set_rates(Vm& vm, std::span<const double> rates, CallPart part) {
  return take(vm, rates, "the largest rates of torques", part, rates_);
}

JointVector MotorLimits::given(const JointVector& tau, double hold) {
  JointVector cut = tau.cwiseMax(-most_).cwiseMin(most_);
  if (rates_.size() != 0 && before_.size() != 0) {
    const JointVector step = rates_ * hold;
    cut = cut.cwiseMax(before_ - step).cwiseMin(before_ + step);
  }
  if (cut != tau) clipped_ += hold;
  before_ = cut;
  return cut;
}

Answer<MotorLimits> motor_limits(Vm& vm, const SimulationCall& call, const Robot& robot) {
  MotorLimits limits(robot);
  if (call.most && !limits.set_most(vm, *call.most, at("maxTorques"))) return Failed{};
  if (call.rates && !limits.set_rates(vm, *call.rates, at("maxTorqueRates"))) return Failed{};
  return limits;
}

Failed cannot_simulate(Vm& vm, const ArmSimulation& arm, const SimulationOutcome& outcome,
                       const SimulationOptions& options) {
  const std::string where = fmt::format("joint {} of `{}`", outcome.joint + 1, arm.robot().name());
  const auto refuse = [&](const std::string& what, std::string fix) {
    Failure f;
    f.headline = {row("R0640"),
                  {fmt::format("the simulation ends at {:.6g} s: {}", outcome.t, what)}};
    f.mark = at("law");
    f.resource = robot_called(arm.robot().name());
    f.fix = std::move(fix);
    return fail(vm, std::move(f));
  };
  const std::string_view method = ode_method_names()[static_cast<std::size_t>(options.method)];
  const std::string step = format_number(1e3 * options.step, 6) + " ms";
  switch (outcome.status) {
    case SimulationStatus::kMassless:
      return refuse("nothing resists " + where + ", so no force determines its acceleration",
                    "give its link a mass, or the joint a motorInertia");
    case SimulationStatus::kStepTooLong:
      return refuse(where + " moves too far within one step of " + step, "use a shorter step");
    case SimulationStatus::kStiff:
      return refuse(fmt::format("the friction of {} is too stiff for \"{}\" with steps of {}",
                                where, method, step),
                    "use a shorter step, or method: \"dopri5\"");
    case SimulationStatus::kZeno:
      return refuse("more than 100 events within a nanosecond, the last of " + where,
                    "use a smaller restitution");
    default:
      return refuse("the acceleration of " + where + " is beyond the range of numbers",
                    "use a shorter step, or smaller torques");
  }
}

void tell_of_stops(Vm& vm, const ArmSimulation& arm) {
  for (const SimulationEvent& event : arm.events()) {
    if (event.kind != SimulationEventKind::kStop) continue;
    const Joint& joint = arm.robot().joint(event.joint);
    const double limit = event.speed > 0.0 ? joint.upper : joint.lower;
    Failure advice;
    advice.headline = {row("W0720"),
                       {std::to_string(event.joint + 1), format_joint_value(joint.kind, limit),
                        fmt::format("{:.6g}", event.t)}};
    advice.mark = at("law");
    vm.advise(advice);
    return;
  }
}

ListObj* joint_events(Vm& vm, const ArmSimulation& arm) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(arm.events().size()), true);
  std::uint32_t k = 0;
  for (const SimulationEvent& event : arm.events()) {
    if (list == nullptr) break;
    RecordObj* record = new_record(vm, vm.program().library_record("JointEvent"));
    Obj* kind = record != nullptr ? new_text(vm, name_of(event.kind)) : nullptr;
    list->data[k++].o = record;
    if (kind != nullptr) {
      record->fields()[0] = slot_of(event.t);
      record->fields()[1].o = kind;
      record->fields()[2] = slot_of(std::int64_t{event.joint + 1});
      record->fields()[3] = slot_of(event.speed);
      continue;
    }
    release(vm, list);
    list = nullptr;
  }
  return list;
}

}  // namespace armlet::bind
