#include "moves/grips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/cell/collisions.hpp"
#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

Failed fail_overload(Vm& vm, const MoveCall& call, const std::string& what, double force,
                     double most, std::string why, std::string fix) {
  Failure f;
  f.headline = {row("R0637"),
                {what, format_number(force, 3) + " N", format_number(most, 3) + " N"}};
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.mark = CallPart::callee();
  f.place = call.place;
  f.why = std::move(why);
  f.fix = std::move(fix);
  f.moved = true;
  return fail(vm, std::move(f));
}

constexpr const char* kGuardFinger =
    "guard the move, `until f.force() > 3N`, or say closeHand(hand, force: 5N)";
constexpr const char* kLinksToo = "the maxForce of the hand counts for the links too";
constexpr const char* kGuardTool = "guard the move: `until arm.force().z > 10N`";

// The hand with fingers that a robot is, belongs to or carries; -1: none.
int fingered_hand(const Cell& cell, int robot) {
  const CellRobot& state = cell.robot(robot);
  if (state.on >= 0) return state.hand < 0 ? robot : state.hand;
  return cell.hand_on(robot);
}

std::string part_text(const Cell& cell, int robot, const Press& by) {
  CellBody body{.robot = robot, .object = by.carried, .frame = by.frame};
  body.role = LinkShapeRole::kTool;
  if (by.carried.empty() && by.part >= 0) {
    const auto& solids = cell.robot(robot).model->derived<ArmSolids>().solids();
    body.role = solids[static_cast<std::size_t>(by.part)].role;
  }
  return by.carried.empty()
             ? body_text(cell, body)
             : fmt::format("{} {} `{}`", body_text(cell, body),
                           by.of_hand ? "in the hand of" : "on", cell.robot(robot).name);
}

std::string finger_text(const Cell& cell, int hand, int finger) {
  return fmt::format("finger {} of `{}`", finger + 1, cell.robot(hand).name);
}

// The contact force on the hand, or on the links.
double force_on(const Cell& cell, int robot, bool of_hand) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Press& each : cell.presses(robot)) {
    if (each.of_hand == of_hand) sum += each.force;
  }
  return sum.norm();
}

}  // namespace

void advise_slip(Vm& vm, const CellEvent& event) {
  Failure advice;
  advice.headline = {row("W0726"), {event.object}};
  advice.mark = CallPart::callee();
  const double percent = 100.0 * std::min(event.carried, 0.99);
  if (event.moving) {
    advice.why = fmt::format(
        "at t = {:.3f} s the arm accelerated, and friction at the fingers carried {:.0f} % of its "
        "weight and inertia",
        to_seconds(event.t_ns), percent);
    advice.fix =
        "move more slowly, close the fingers with more force, or take it nearer to its middle";
  } else {
    advice.why = fmt::format("friction at the fingers carries {:.0f} % of its weight", percent);
    advice.fix = "close the fingers with more force, or take it nearer to its middle";
  }
  vm.advise(advice);
}

Answer<void> check_overload(Vm& vm, const MoveCall& call, const MotionReport& report) {
  if (!report.overload) return {};
  const Cell& cell = Host::of(vm).cell();
  const HandOverload& over = *report.overload;
  const int hand = fingered_hand(cell, report.robot);
  const bool is_finger = over.finger >= 0 && hand >= 0;
  const double now =
      is_finger ? hardest_finger(cell, hand).force : force_on(cell, report.robot, over.by.of_hand);
  std::string why = fmt::format(
      "on \"{}\" it came to {} N at t = {:.6g} s, {} s after the start of this motion, which began "
      "to stop there",
      over.by.object, format_number(over.force, 3), to_seconds(over.t_ns),
      format_number(to_seconds(over.t_ns - report.start_ns), 3));
  if (!is_finger && !over.by.of_hand) why += fmt::format("; {}", kLinksToo);
  return fail_overload(
      vm, call,
      is_finger ? finger_text(cell, hand, over.finger) : part_text(cell, report.robot, over.by),
      std::max(now, over.force), over.most, std::move(why), is_finger ? kGuardFinger : kGuardTool);
}

Answer<void> check_presses(Vm& vm, const MoveCall& call, const MotionReport& report) {
  if (report.overload) return check_overload(vm, call, report);
  const Cell& cell = Host::of(vm).cell();
  const CellRobot& robot = cell.robot(call.robot);
  if (robot.on >= 0) {
    const int hand = fingered_hand(cell, call.robot);
    const HardestFinger hardest = hardest_finger(cell, hand);
    const double most = cell.robot(hand).force;
    if (hardest.force <= most) return {};
    return fail_overload(vm, call, finger_text(cell, hand, hardest.finger), hardest.force, most,
                         fmt::format("on \"{}\"", hardest.object), kGuardFinger);
  }
  const double most = robot.model->tool().max_force;
  if (!std::isfinite(most)) return {};
  for (const bool of_hand : {true, false}) {
    const double force = force_on(cell, call.robot, of_hand);
    if (force <= most) continue;
    const char* const part = of_hand ? "the tool" : "a link";
    return fail_overload(vm, call, fmt::format("{} of `{}`", part, robot.name), force, most,
                         of_hand ? "" : kLinksToo, kGuardTool);
  }
  return {};
}

}  // namespace armlet::bind
