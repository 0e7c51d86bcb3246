#include "motion/motion_torques.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"

namespace armlet::bind {
namespace {

std::string force_text(const Robot& robot, int joint, double force) {
  const bool turns = robot.joint(joint).kind == JointKind::kRevolute;
  return fmt::format("{:.4g} {}", std::abs(force), turns ? "Nm" : "N");
}

// What to do about a motion of so many seconds.
std::string remedy(const MotionForces& forces, double duration) {
  if (!std::isfinite(forces.slower)) return "carry less, or go where the arm holds it";
  const double milliseconds = std::ceil(1e3 * duration * forces.slower);
  return fmt::format("let it take {} s, or carry less", format_number(1e-3 * milliseconds, 3));
}

}  // namespace

Answer<void> check_torques(Vm& vm, const MoveCall& call, const Trajectory& motion) try {
  const TorqueCheck wanted = settings_of(vm).torques;
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  const Robot& robot = *state.loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(robot) || motion.duration() <= 0.0)
    return {};
  const MotionForces forces = motion_forces(robot, motion);
  if (forces.nearest < 0) return {};
  const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
  if (peak.share() <= 1.0) return {};
  Failure f;
  const std::string joint = std::to_string(forces.nearest + 1);
  const std::string asked = force_text(robot, forces.nearest, peak.force);
  const std::string at = format_number(peak.t, 2) + " s";
  const std::string limit = force_text(robot, forces.nearest, peak.limit);
  if (wanted == TorqueCheck::kError) {
    f.headline = {row("R0642"), {joint, asked, at, limit}};
  } else {
    f.headline = {row("W0721"), {joint, asked, at, limit}};
  }
  f.mark_parameter = kMarkCallee;
  f.place = call.place;
  f.fix = remedy(forces, motion.duration());
  if (!std::isfinite(forces.slower)) f.why = "holding the arm there takes more than that already";
  if (wanted == TorqueCheck::kReport) {
    vm.advise(f);
    return {};
  }
  f.resource = robot_called(state.name);
  f.moved = false;
  return fail(vm, std::move(f));
} catch (const ArgumentError&) {
  return {};  // masses that have no forces, of which the functions of dynamics speak
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
