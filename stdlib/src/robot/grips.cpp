#include "robot/grips.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"

namespace armlet::bind {
namespace {

Failed fail_overload(Vm& vm, const MoveCall& call, const std::string& what, double force,
                     double most, std::string fix) {
  Failure f;
  f.headline = {row("R0637"),
                {what, format_number(force, 3) + " N", format_number(most, 3) + " N"}};
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.mark_parameter = kMarkCallee;
  f.place = call.place;
  f.fix = std::move(fix);
  f.moved = true;
  return fail(vm, std::move(f));
}

// The finger that presses hardest, from 0, and what with.
std::pair<std::size_t, double> hardest(const Cell& cell, const CellRobot& hand) {
  std::pair<std::size_t, double> most{0, 0.0};
  for (std::size_t i = 0; i < hand.fingers.size(); ++i) {
    const double force = finger_force(cell, hand.fingers[i]);
    if (force > most.second) most = {i, force};
  }
  return most;
}

}  // namespace

void advise_slip(Vm& vm, const CellEvent& event) {
  Failure advice;
  advice.headline = {row("W0726"), {event.object}};
  advice.mark_parameter = kMarkCallee;
  advice.why = fmt::format("friction at the fingers carries {:.0f} % of its weight",
                           100.0 * std::min(event.carried, 0.99));
  advice.fix = "close the fingers with more force, or take it nearer to its middle";
  vm.advise(advice);
}

Answer<void> check_presses(Vm& vm, const MoveCall& call) {
  const Cell& cell = Host::of(vm).cell();
  const CellRobot& robot = cell.robot(call.robot);
  if (robot.on >= 0) {
    const CellRobot& hand = robot.hand < 0 ? robot : cell.robot(robot.hand);
    const auto [finger, force] = hardest(cell, hand);
    if (force <= hand.force) return {};
    return fail_overload(vm, call, fmt::format("finger {} of `{}`", finger + 1, hand.name), force,
                         hand.force,
                         "guard the move, `until f.force() > 3N`, or say closeHand(hand, force: "
                         "5N)");
  }
  const double most = robot.model->tool().max_force;
  if (!std::isfinite(most)) return {};
  const double force = cell.contact_wrench(call.robot).head<3>().norm();
  if (force <= most) return {};
  return fail_overload(vm, call, fmt::format("the tool of `{}`", robot.name), force, most,
                       "guard the move: `until arm.force().z > 10N`");
}

}  // namespace armlet::bind
