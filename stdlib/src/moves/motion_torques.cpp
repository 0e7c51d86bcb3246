#include "moves/motion_torques.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "armlet/core/format.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

// The fix for a motion of this duration.
std::string remedy(const MotionForces& forces, double duration) {
  if (!std::isfinite(forces.slower)) return "carry less, or go where the arm holds it";
  const double milliseconds = std::ceil(1e3 * duration * forces.slower);
  return fmt::format("let it take {} s, or carry less", format_number(1e-3 * milliseconds, 3));
}

// Whether a motor would exceed its limit.
bool is_beyond(const MotionForces& forces) {
  constexpr double kRounding = 1e-9;
  return forces.nearest >= 0 &&
         forces.peaks[static_cast<std::size_t>(forces.nearest)].share() > 1.0 + kRounding;
}

// Whether a command that directly follows another one is checked.
bool is_looked_at(const Host& host, int robot, std::int64_t during_ns) {
  constexpr std::int64_t kEvery = 5'000'000;  // ns
  const std::int64_t now = host.now_ns();
  const int last = host.cell().robot(robot).motion_id;
  const bool goes_on = last >= 0 && host.cell().report(last).held_ns == now;
  return !goes_on || (now - 1) / kEvery != (now + during_ns - 1) / kEvery;
}

Failure about(const MoveCall& call) {
  Failure f;
  f.mark_parameter = kMarkCallee;
  f.place = call.place;
  return f;
}

Failed refuse(Vm& vm, const MoveCall& call, Failure f) {
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  return fail(vm, std::move(f));
}

Failure too_strong(const MoveCall& call, const Robot& robot, const MotionForces& forces,
                   std::string fix, bool refused) {
  const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
  Failure f = about(call);
  const std::vector<std::string> words = {
      std::to_string(forces.nearest + 1), force_text(robot, forces.nearest, peak.force),
      format_number(peak.t, 2) + " s", force_text(robot, forces.nearest, peak.limit)};
  if (refused) {
    f.headline = {row("R0642"), {words[0], words[1], words[2], words[3]}};
  } else {
    f.headline = {row("W0721"), {words[0], words[1], words[2], words[3]}};
  }
  f.fix = std::move(fix);
  if (!std::isfinite(forces.slower)) f.why = "holding the arm there takes more than that already";
  return f;
}

// Forces beyond the range of doubles exceed the limit of any motor.
Answer<double> beyond_numbers(Vm& vm, const MoveCall& call, TorqueCheck wanted,
                              const ArgumentError& error) {
  Failure f = about(call);
  if (wanted == TorqueCheck::kReport) {
    f.headline = {row("W0722"), {clause_of(error)}};
    vm.advise(f);
    return 1.0;
  }
  f.headline = {row("R0640"), {clause_of(error)}};
  return refuse(vm, call, std::move(f));
}

}  // namespace

std::string force_text(const Robot& robot, int joint, double force) {
  const bool turns = robot.joint(joint).kind == JointKind::kRevolute;
  return fmt::format("{:.4g} {}", std::abs(force), turns ? "Nm" : "N");
}

Answer<double> check_torques(Vm& vm, const MoveCall& call, const Trajectory& motion) {
  const TorqueCheck wanted = settings_of(vm).torques;
  const Robot& robot = *Host::of(vm).cell().robot(call.robot).loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(robot) || motion.duration() <= 0.0)
    return 1.0;
  try {
    const MotionForces forces = motion_forces(robot, motion);
    if (!is_beyond(forces)) return 1.0;
    const bool slows = wanted == TorqueCheck::kLimit && !call.fixed_time;
    if (slows && std::isfinite(forces.slower)) return forces.slower;
    const bool refused = wanted != TorqueCheck::kReport;
    Failure f = too_strong(call, robot, forces, remedy(forces, motion.duration()), refused);
    if (refused) return refuse(vm, call, std::move(f));
    vm.advise(f);
    return 1.0;
  } catch (const ArgumentError& error) {
    return beyond_numbers(vm, call, wanted, error);
  }
}

Answer<void> check_velocity_torques(Vm& vm, const MoveCall& call, const Trajectory& motion,
                                    std::int64_t during_ns) {
  const TorqueCheck wanted = settings_of(vm).torques;
  const Robot& robot = *Host::of(vm).cell().robot(call.robot).loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(robot)) return {};
  if (!is_looked_at(Host::of(vm), call.robot, during_ns)) return {};
  try {
    const MotionForces forces = command_forces(robot, motion, 0.0, to_seconds(during_ns));
    if (!is_beyond(forces)) return {};
    const bool refused = wanted != TorqueCheck::kReport;
    Failure f =
        too_strong(call, robot, forces,
                   std::isfinite(forces.slower) ? "change the speed in smaller steps, or carry less"
                                                : "carry less, or go where the arm holds it",
                   refused);
    if (refused) return refuse(vm, call, std::move(f));
    vm.advise(f);
    return {};
  } catch (const ArgumentError& error) {
    if (!beyond_numbers(vm, call, wanted, error)) return Failed{};
    return {};
  }
}

void remember_rest(Vm& vm, const MoveCall& call, Trajectory path, int motion) {
  Host& host = Host::of(vm);
  if (settings_of(vm).torques == TorqueCheck::kIgnore) return;
  if (!has_force_limits(*host.cell().robot(call.robot).loaded)) return;
  host.remember_rest(call.robot,
                     {motion, std::move(path), std::string(call.function), place_of_call(vm)});
}

void report_rest(Vm& vm, int index) {
  Host& host = Host::of(vm);
  const std::optional<LastRest> last = host.take_rest(index);
  if (!last) return;
  const MotionReport& report = host.cell().report(last->motion);
  const std::int64_t until = std::min(report.end_ns, host.now_ns());
  if (report.halted || report.state == MotionState::kStopped || until <= *report.held_ns) return;
  const Robot& robot = *host.cell().robot(index).loaded;
  const MoveCall call{.function = last->function, .robot = index, .place = last->place};
  try {
    const MotionForces forces =
        command_forces(robot, last->path, to_seconds(*report.held_ns - report.start_ns),
                       to_seconds(until - report.start_ns));
    if (!is_beyond(forces)) return;
    Failure f = too_strong(call, robot, forces,
                           "slow down in smaller steps before the last of them ends", false);
    f.why = "that is on the way to rest, which the robot takes where no other command follows";
    vm.advise(f);
  } catch (const ArgumentError& error) {
    static_cast<void>(beyond_numbers(vm, call, TorqueCheck::kReport, error));
  }
}

void report_rests(Vm& vm) {
  for (int i = 0; i < Host::of(vm).cell().robot_count(); ++i) report_rest(vm, i);
}

std::string torques_text(const Robot& robot, const Trajectory& motion) try {
  if (!has_force_limits(robot)) return {};
  const MotionForces forces = motion_forces(robot, motion);
  if (forces.nearest < 0) return {};
  const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
  return fmt::format("\n  joint {} comes nearest to what its motor gives: {} ({} %) at {} s",
                     forces.nearest + 1, force_text(robot, forces.nearest, peak.force),
                     format_number(100.0 * peak.share(), 1), format_number(peak.t, 2));
} catch (const ArgumentError&) {
  return {};
}

}  // namespace armlet::bind
