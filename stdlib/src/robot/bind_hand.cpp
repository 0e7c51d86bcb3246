// Grippers: grasp, release, holding (language reference, section 14).

#include <fmt/format.h>

#include "armlet/cell/gripper.hpp"
#include "armlet/core/format.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "robot/grasps.hpp"
#include "values/bind.hpp"
#include "values/robots/models.hpp"
#include "values/robots/robot_state.hpp"
#include "values/values.hpp"

namespace armlet::bind {

Failed fail_grasp(Vm& vm, int robot, const GraspResult& result) {
  const Cell& cell = Host::of(vm).cell();
  Failure f;
  f.headline = Headline(row("R0605"));
  f.resource = robot_called(cell.robot(robot).name);
  switch (result.status) {
    case GraspStatus::kNothing:
      f.why = result.object.empty()
                  ? "there is no object that could be grasped in this world"
                  : fmt::format(
                        "the centre of \"{}\" is {} from the fingers; the gripper closes on things "
                        "within {}",
                        result.object, format_mm(result.distance), format_mm(result.allowed));
      if (!result.object.empty()) f.fix = fmt::format("move to poseOf({}) first", result.object);
      break;
    case GraspStatus::kTooWide:
      f.headline = Headline::own(row("R0605"),
                                 fmt::format("\"{}\" is too wide for this gripper", result.object));
      f.why = fmt::format("between the fingers it is {} wide, and the gripper opens {}",
                          format_mm(result.width), format_mm(result.stroke));
      f.fix =
          result.turned <= result.stroke
              ? fmt::format("rotate the gripper by 90 deg about its approach: there it is {} wide",
                            format_mm(result.turned))
              : "grasp it from another side, or use a gripper with a longer stroke";
      break;
    case GraspStatus::kFixed:
      f.headline = Headline::own(
          row("R0605"), fmt::format("\"{}\" is fixed and cannot be grasped", result.object));
      break;
    case GraspStatus::kNoHand:
      f.headline = Headline::own(row("R0605"),
                                 fmt::format("`{}` has no hand that can grasp", f.resource.name));
      f.fix = Host::of(vm).cell().hand_on(robot) >= 0 || Host::of(vm).cell().robot(robot).on >= 0
                  ? "close its fingers: closeHand(hand)"
                  : "give it one: tool: parallelGripper(stroke: 60mm)";
      break;
    case GraspStatus::kHolding:
      f.headline = Headline::own(
          row("R0605"), fmt::format("the hand is closed on \"{}\" already", result.object));
      f.fix = "release it first";
      break;
    case GraspStatus::kUnknownObject:
      f.headline = {row("R0625"), {result.object}};
      break;
    case GraspStatus::kGrasped:
      break;
  }
  return fail(vm, std::move(f));
}

namespace {

Answer<void> grasp_object(Vm& vm, const RobotRef& r, const ObjectRef& o) {
  if (!check_idle(vm, r.id)) return Failed{};
  const GraspResult result = grasp(Host::of(vm).cell(), r.id, o.name);
  if (!result.ok()) return fail_grasp(vm, r.id, result);
  return {};
}
Answer<void> grasp_nearest(Vm& vm, const RobotRef& r) {
  if (!check_idle(vm, r.id)) return Failed{};
  const GraspResult result = grasp(Host::of(vm).cell(), r.id);
  if (!result.ok()) return fail_grasp(vm, r.id, result);
  return {};
}
Answer<void> release_object(Vm& vm, const RobotRef& r) {
  Cell& cell = Host::of(vm).cell();
  if (!check_idle(vm, r.id)) return Failed{};
  if (release(cell, r.id)) return {};
  Failure f;
  f.resource = robot_called(cell.robot(r.id).name);
  f.headline = {row("R0619"), {f.resource.name}};
  f.fix = "grasp something first, or ask holding()";
  return fail(vm, std::move(f));
}
bool holding_any(Vm& vm, const RobotRef& r) { return !holding(Host::of(vm).cell(), r.id).empty(); }
bool holding_this(Vm& vm, const RobotRef& r, const ObjectRef& o) {
  return holding(Host::of(vm).cell(), r.id) == o.name;
}

constexpr NativeFunction kHandFunctions[] = {
    def<grasp_object>(
        "grasp(r: robot, o: object)",
        "Closes the hand on an object whose centre or grasp point is within the grasp distance of "
        "the tool point; a long object can be taken along its length. What rests on it travels "
        "with it.",
        "grasp(object(\"cube\"))", {.commands = true}),
    def<grasp_nearest>(
        "grasp(r: robot)",
        "Closes the hand on the nearest object within the grasp distance of the tool point.",
        "grasp()", {.commands = true}),
    def<release_object>("release(r: robot)",
                        "Opens the hand; what it held falls straight down to the first surface.",
                        "release()", {.commands = true}),
    def<holding_any>("holding(r: robot) -> bool", "Whether the hand holds something.", "holding()"),
    def<holding_this>("holding(r: robot, o: object) -> bool", "Whether the hand holds this object.",
                      "holding(object(\"cube\"))"),
};

}  // namespace

std::span<const NativeFunction> hand_functions() { return kHandFunctions; }

}  // namespace armlet::bind
