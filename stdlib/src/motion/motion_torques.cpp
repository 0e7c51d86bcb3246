#include "motion/motion_torques.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"

namespace armlet::bind {
namespace {

// What to do about a motion of so many seconds.
std::string remedy(const MotionForces& forces, double duration) {
  if (!std::isfinite(forces.slower)) return "carry less, or go where the arm holds it";
  const double milliseconds = std::ceil(1e3 * duration * forces.slower);
  return fmt::format("let it take {} s, or carry less", format_number(1e-3 * milliseconds, 3));
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
                   double duration, bool refused) {
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
  f.fix = remedy(forces, duration);
  if (!std::isfinite(forces.slower)) f.why = "holding the arm there takes more than that already";
  return f;
}

// Forces that no number can hold are more than any motor gives.
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
  constexpr double kRounding = 1e-9;
  const TorqueCheck wanted = settings_of(vm).torques;
  const Robot& robot = *Host::of(vm).cell().robot(call.robot).loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(robot) || motion.duration() <= 0.0)
    return 1.0;
  try {
    const MotionForces forces = motion_forces(robot, motion);
    if (forces.nearest < 0) return 1.0;
    const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
    if (peak.share() <= 1.0 + kRounding) return 1.0;
    const bool slows = wanted == TorqueCheck::kLimit && !call.fixed_time;
    if (slows && std::isfinite(forces.slower)) return forces.slower;
    const bool refused = wanted != TorqueCheck::kReport;
    Failure f = too_strong(call, robot, forces, motion.duration(), refused);
    if (refused) return refuse(vm, call, std::move(f));
    vm.advise(f);
    return 1.0;
  } catch (const ArgumentError& error) {
    return beyond_numbers(vm, call, wanted, error);
  }
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
