// Hands: grasp, release, holding (language reference, section 14).

#include <fmt/format.h>

#include "armlet/cell/gripper.hpp"
#include "armlet/core/format.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "moves.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

Failed fail_grasp(Vm& vm, int robot, const GraspResult& result) {
  const Cell& cell = Host::of(vm).cell();
  Failure f;
  f.code = "R0605";
  f.robot = cell.robot(robot).name;
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
      f.message = fmt::format("\"{}\" is too wide for this gripper", result.object);
      f.why = fmt::format("it is {} wide and the gripper opens {}", format_mm(result.width),
                          format_mm(result.stroke));
      f.fix = "grasp it from another side, or use a gripper with a longer stroke";
      break;
    case GraspStatus::kFixed:
      f.message = fmt::format("\"{}\" is fixed and cannot be grasped", result.object);
      break;
    case GraspStatus::kNoHand:
      f.message = fmt::format("`{}` has no hand that can grasp", f.robot);
      f.fix = "give it one: tool: parallelGripper(stroke: 60mm)";
      break;
    case GraspStatus::kHolding:
      f.message = fmt::format("the hand is closed on \"{}\" already", result.object);
      f.fix = "release it first";
      break;
    case GraspStatus::kUnknownObject:
      f.code = "R0625";
      f.arguments = {result.object};
      break;
    case GraspStatus::kGrasped:
      break;
  }
  return fail(vm, std::move(f));
}

Signal grasp_object(Vm& vm, Slot* args) {
  const int robot = robot_id(args[0]);
  if (refuse_busy(vm, robot)) return Signal::kFail;
  const GraspResult result = grasp(Host::of(vm).cell(), robot, host_value<ObjectRef>(args[1]).name);
  return result.ok() ? give_nothing() : fail_grasp(vm, robot, result);
}
Signal grasp_nearest(Vm& vm, Slot* args) {
  const int robot = robot_id(args[0]);
  if (refuse_busy(vm, robot)) return Signal::kFail;
  const GraspResult result = grasp(Host::of(vm).cell(), robot);
  return result.ok() ? give_nothing() : fail_grasp(vm, robot, result);
}
Signal release_object(Vm& vm, Slot* args) {
  Cell& cell = Host::of(vm).cell();
  const int robot = robot_id(args[0]);
  if (refuse_busy(vm, robot)) return Signal::kFail;
  if (release(cell, robot)) return give_nothing();
  Failure f;
  f.code = "R0619";
  f.robot = cell.robot(robot).name;
  f.arguments = {f.robot};
  f.fix = "grasp something first, or ask holding()";
  return fail(vm, std::move(f));
}
Signal holding_any(Vm& vm, Slot* args) {
  return give(args, !holding(Host::of(vm).cell(), robot_id(args[0])).empty());
}
Signal holding_this(Vm& vm, Slot* args) {
  return give(
      args, holding(Host::of(vm).cell(), robot_id(args[0])) == host_value<ObjectRef>(args[1]).name);
}

constexpr NativeFunction kHandFunctions[] = {
    commanding({"grasp", "(r: robot, o: object)",
                "Closes the hand on an object whose centre or grasp point is within the grasp "
                "distance of the tool point; "
                "a long object can be taken along its length. What rests on it travels with it.",
                "grasp(object(\"cube\"))", grasp_object}),
    commanding(
        {"grasp", "(r: robot)",
         "Closes the hand on the nearest object within the grasp distance of the tool point.",
         "grasp()", grasp_nearest}),
    commanding({"release", "(r: robot)",
                "Opens the hand; what it held falls straight down to the first surface.",
                "release()", release_object}),
    {"holding", "(r: robot) -> bool", "Whether the hand holds something.", "holding()",
     holding_any},
    {"holding", "(r: robot, o: object) -> bool", "Whether the hand holds this object.",
     "holding(object(\"cube\"))", holding_this},
};

}  // namespace

std::span<const NativeFunction> hand_functions() { return kHandFunctions; }

}  // namespace armlet::bind
