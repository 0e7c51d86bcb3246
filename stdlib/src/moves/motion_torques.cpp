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
  f.mark = CallPart::callee();
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
Failure beyond_numbers(const MoveCall& call, const TorqueReport& report) {
  Failure f = about(call);
  std::string clause = clause_of(ArgumentError(report.beyond_numbers));
  if (report.is_refused) {
    f.headline = {row("R0640"), {std::move(clause)}};
  } else {
    f.headline = {row("W0722"), {std::move(clause)}};
  }
  return f;
}

// Advice or a failure about torques beyond the limits, with this fix.
Answer<void> word(Vm& vm, const MoveCall& call, const TorqueReport& report, std::string fix,
                  std::string why = {}) {
  if (!report.is_beyond()) return {};
  const Robot& robot = *Host::of(vm).cell().robot(call.robot).loaded;
  Failure f = report.forces
                  ? too_strong(call, robot, *report.forces, std::move(fix), report.is_refused)
                  : beyond_numbers(call, report);
  if (report.forces && !why.empty()) f.why = std::move(why);
  if (report.is_refused) return refuse(vm, call, std::move(f));
  vm.advise(f);
  return {};
}

}  // namespace

std::string force_text(const Robot& robot, int joint, double force) {
  const bool turns = robot.joint(joint).kind == JointKind::kRevolute;
  return fmt::format("{:.4g} {}", std::abs(force), turns ? "Nm" : "N");
}

Answer<void> word_torques(Vm& vm, const MoveCall& call, const TorqueReport& report) {
  return word(vm, call, report, report.forces ? remedy(*report.forces, report.duration) : "");
}

Answer<void> check_velocity_torques(Vm& vm, const MoveCall& call, const Trajectory& motion,
                                    std::int64_t during_ns) {
  if (!is_looked_at(Host::of(vm), call.robot, during_ns)) return {};
  const TorqueReport report = check_command_torques(Host::of(vm).cell(), call.robot, motion, 0.0,
                                                    to_seconds(during_ns), settings_of(vm).torques);
  return word(vm, call, report,
              report.forces && std::isfinite(report.forces->slower)
                  ? "change the speed in smaller steps, or carry less"
                  : "carry less, or go where the arm holds it");
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
  const MoveCall call{.function = last->function, .robot = index, .place = last->place};
  const TorqueReport torques = check_command_torques(
      host.cell(), index, last->path, to_seconds(*report.held_ns - report.start_ns),
      to_seconds(until - report.start_ns), TorqueCheck::kReport);
  static_cast<void>(
      word(vm, call, torques, "slow down in smaller steps before the last of them ends",
           "that is on the way to rest, which the robot takes where no other command follows"));
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
