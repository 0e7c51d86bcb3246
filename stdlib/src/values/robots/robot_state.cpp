#include "values/robots/robot_state.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "armlet/control/make_move.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

Answer<void> check_arm(Vm& vm, int id) {
  const CellRobot& robot = Host::of(vm).cell().robot(id);
  if (robot.on < 0) return {};
  Failure f;
  f.resource = robot_called(robot.name);
  f.headline = {row("R0651"), {robot.name}};
  f.mark = CallPart::callee();
  f.fix = fmt::format("ask `{}`, which carries it", Host::of(vm).cell().robot(robot.on).name);
  return fail(vm, std::move(f));
}

Failed fail_busy(Vm& vm, int part) {
  const CellRobot& robot = Host::of(vm).cell().robot(part);
  Failure f;
  f.resource = robot_called(robot.name);
  f.headline = {"R0617", {robot.name, std::string(kRobot.resource->busy)}};
  f.mark = CallPart::callee();
  const MotionReport& report = Host::of(vm).cell().report(robot.motion_id);
  const bool rolls_out = report.held_ns && *report.held_ns <= Host::of(vm).now_ns();
  f.fix = rolls_out ? "it is slowing down after a velocity command: call halt() first"
                    : "wait until its move has ended";
  return fail(vm, std::move(f));
}

Answer<void> check_idle(Vm& vm, int given) {
  if (const auto part = moving_part(Host::of(vm).cell(), given)) return fail_busy(vm, *part);
  return {};
}

}  // namespace armlet::bind
