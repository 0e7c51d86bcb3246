// Inverse kinematics and what it says about itself (language reference, section 19).

#include <fmt/format.h>

#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "give.hpp"
#include "move_failures.hpp"
#include "moves.hpp"
#include "rules.hpp"

namespace armlet::bind {
namespace {

// ikine(r, p, near, mask, axes, posture); the last is a word or joint values.
enum Parameter { kArm, kTarget, kNear, kMask, kAxes, kPosture };

bool read_mask(Vm& vm, Slot* args, IkOptions& options) {
  if (args[kMask].o == nullptr) return true;
  const auto items = items_value(args[kMask]);
  if (items.size() != 6) {
    static_cast<void>(
        failure(vm, "R0613", fmt::format("a mask has 6 values, not {}", items.size()), kMask,
                "they stand for x, y, z and the turns about x, y, z: 1 counts, 0 does not"));
    return false;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    if (items[i].i != 0 && items[i].i != 1) {
      static_cast<void>(failure(
          vm, "R0609", fmt::format("a mask of {}: its values are 1 or 0", items[i].i), kMask,
          "1 counts, 0 does not", "to keep the place only: mask: [1, 1, 1, 0, 0, 0]"));
      return false;
    }
    options.mask[i] = items[i].i == 1;
  }
  options.task = IkTask::kMasked;
  return true;
}

bool read_axes(Vm& vm, Slot* args, IkOptions& options) {
  const std::string_view axes = text_value(args[kAxes]);
  if (axes == "tool") options.mask_frame = IkMaskFrame::kTool;
  if (axes == "tool" || axes == "world") return true;
  static_cast<void>(failure(vm, "R0626", fmt::format("a mask has no axes \"{}\"", axes), kAxes,
                            "its axes are those of the \"world\" or of the \"tool\""));
  return false;
}

bool read_posture(Vm& vm, const Robot& robot, Slot value, bool is_word, IkOptions& options) {
  if (value.o == nullptr) return true;
  if (!is_word) {
    auto q = joint_argument(vm, robot, value, false, kPosture);
    if (!q) return false;
    options.posture.emplace(Posture::kNearGiven, *std::move(q));
    return true;
  }
  const std::string_view word = text_value(value);
  if (word == "midRange") options.posture = Posture::kMidRange;
  if (word == "manipulability") options.posture = Posture::kManipulability;
  if (options.posture) return true;
  static_cast<void>(failure(
      vm, "R0626", fmt::format("there is no posture called \"{}\"", word), kPosture,
      "\"midRange\" keeps the joints in the middle of their ranges, \"manipulability\" keeps away "
      "from singularities",
      "use one of these, or give joint values to stay near: posture: home()"));
  return false;
}

// A question of a program: the goal and how it is asked.
struct Question {
  Eigen::Isometry3d T_world_tool;
  IkOptions options;
  bool tilted = false;  // an orientation that this arm cannot take, whatever its joints do
};

template <bool kWord, bool kNearList>
std::optional<Question> question_of(Vm& vm, Slot* args) {
  const CellRobot& state = state_of(vm, args[kArm]);
  const Robot& robot = *state.model;
  const PosC& target = posc(args[kTarget]);
  Question out{.T_world_tool = target.T};
  IkOptions& options = out.options;
  options.seed = state.q;
  if (args[kNear].o != nullptr) {
    auto near = joint_argument(vm, robot, args[kNear], kNearList, kNear);
    if (!near) return std::nullopt;
    options.seed = *std::move(near);
  }
  const auto task = task_of(robot, target);
  if (task) options.task = *task;
  if (!read_mask(vm, args, options) || !read_axes(vm, args, options) ||
      !read_posture(vm, robot, args[kPosture], kWord, options))
    return std::nullopt;
  out.tilted = !task && options.task != IkTask::kMasked;
  // A place alone keeps the orientation that there is.
  if (options.task == IkTask::kMasked && !target.has_orientation)
    out.T_world_tool.linear() = forward(robot, options.seed).linear();
  if (options.task == IkTask::kMasked && task == IkTask::kTurn)
    out.T_world_tool = turned_like(robot, target.T, options.seed);
  return out;
}

template <bool kWord, bool kNearList = false>
Signal ikine(Vm& vm, Slot* args) {
  const auto question = question_of<kWord, kNearList>(vm, args);
  if (!question) return Signal::kFail;
  const MoveCall call{.function = "ikine", .robot = robot_id(args[kArm])};
  if (question->tilted) return fail_tilted(vm, call, posc(args[kTarget]));
  const Robot& robot = *state_of(vm, args[kArm]).model;
  const IkResult result = solve_ik(robot, question->T_world_tool, question->options);
  if (!result.ok()) return fail_unreachable(vm, call, question->T_world_tool, result);
  return give(args, new_posj(vm, make_posj(robot, result.q)));
}

Signal give_report(Vm& vm, Slot* args, const Question& question) {
  const CellRobot& state = state_of(vm, args[kArm]);
  if (question.tilted) {
    return give(args, new_text(vm, fmt::format("{}: {}", state.name, tilt_reason(*state.model))));
  }
  const Robot& robot = *state.model;
  const IkReport report = report_ik(robot, question.T_world_tool, question.options);
  return give(args, new_text(vm, to_text(robot, question.T_world_tool, report)));
}

template <bool kWord, bool kNearList = false>
Signal explain_ikine(Vm& vm, Slot* args) {
  const auto question = question_of<kWord, kNearList>(vm, args);
  return question ? give_report(vm, args, *question) : Signal::kFail;
}

// (r, p)
Signal explain_place(Vm& vm, Slot* args) {
  const CellRobot& state = state_of(vm, args[kArm]);
  const PosC& target = posc(args[kTarget]);
  const auto task = task_of(*state.model, target);
  Question question{.T_world_tool = target.T, .tilted = !task};
  question.options.seed = state.q;
  question.options.task = task.value_or(IkTask::kPose);
  return give_report(vm, args, question);
}

// (r, q): how the place of these joint values is solved, seen from them.
Signal explain_joints(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[kArm]).model;
  const auto q = joint_argument(vm, robot, args[1], false, 1);
  if (!q) return Signal::kFail;
  Question question{.T_world_tool = forward(robot, *q)};
  question.options.seed = *q;
  return give_report(vm, args, question);
}

// (r, p, limits)
Signal ikine_all(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[kArm]);
  const PosC& target = posc(args[kTarget]);
  std::vector<PosJ> list;
  if (const auto task = task_of(*robot.model, target)) {
    IkOptions options;
    options.seed = robot.q;
    options.task = *task;
    options.respect_limits = args[2].i != 0;
    for (const Eigen::VectorXd& q : solve_ik_all(*robot.model, target.T, options))
      list.push_back(make_posj(*robot.model, q));
  }
  return give_objects<PosJ>(vm, args, list, new_posj);
}

Signal reachable(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[kArm]);
  const PosC& target = posc(args[kTarget]);
  const auto task = task_of(*robot.model, target);
  if (!task) return give(args, false);
  IkOptions options;
  options.seed = robot.q;
  options.task = *task;
  options.diagnose = false;
  return give(args, solve_ik(*robot.model, target.T, options).ok());
}

// explain(ikine(...)) asks the same question.
constexpr NativeFunction explained(NativeFunction function, Thunk explain) {
  function.explain = explain;
  return function;
}

constexpr NativeFunction kIkineFunctions[] = {
    explained({"ikine",
               "(r: robot, p: posC, near: posJ?, mask: int[]?, axes: string = \"world\", "
               "posture: string?) -> posJ",
               "Joint values that bring the tool point to p, the ones nearest to `near` (the "
               "present ones). mask: which of x, y, z and the turns about x, y, z count (1) or do "
               "not (0), along the axes of the \"world\" or the \"tool\". posture: of all joint "
               "values that get there the ones nearest to the middle of the joints' ranges "
               "(\"midRange\") or farthest from singularities (\"manipulability\").",
               "ikine(here(), posture: \"midRange\")", ikine<true>},
              explain_ikine<true>),
    explained({"ikine",
               "(r: robot, p: posC, near: posJ?, mask: int[]?, axes: string = \"world\", "
               "posture: posJ) -> posJ",
               "Of all joint values that bring the tool point to p the ones nearest to a posture, "
               "every joint counted by its range.",
               "ikine(here(), posture: home())", ikine<false>},
              explain_ikine<false>),
    explained({"ikine",
               "(r: robot, p: posC, near: double[], mask: int[]?, axes: string = \"world\", "
               "posture: string?) -> posJ",
               "Joint values that bring the tool point to p, near joint values in rad and m.",
               "ikine(here(), near: [0.0, 0.5, 0.1, 0.0])", ikine<true, true>, nullptr, nullptr,
               check_joint_list<kNear>},
              explain_ikine<true, true>),
    explained({"ikine",
               "(r: robot, p: posC, near: double[], mask: int[]?, axes: string = \"world\", "
               "posture: posJ) -> posJ",
               "Joint values that bring the tool point to p, near joint values in rad and m and "
               "near a posture.",
               "ikine(here(), near: [0.0, 0.5, 0.1, 0.0], posture: home())", ikine<false, true>,
               nullptr, nullptr, check_joint_list<kNear>},
              explain_ikine<false, true>),
    {"ikineAll", "(r: robot, p: posC, limits: bool = true) -> posJ[]",
     "All joint values that bring the tool point to p, the nearest to the present ones first: "
     "every branch of an arm with a closed form; limits: false lists those beyond the joint limits "
     "too. An empty list if there are none. A place without orientation keeps the present one as "
     "far as the arm can; an arm that cannot turn its tool by itself lists every way to the place.",
     "ikineAll(here())", ikine_all},
    {"explain", "(r: robot, q: posJ) -> string",
     "How inverse kinematics comes to these joint values: the solver and why, every branch with "
     "what rules it out. explain(ikine(p)) says the same of a call of ikine, with its settings, "
     "and where there is no solution, why, and the nearest place that can be reached.",
     "print(explain(ikine(xyz(2m, 0m, 300mm))))", explain_joints},
    {"explain", "(r: robot, p: posC) -> string",
     "How inverse kinematics solves p, or why it cannot: the solver, every branch with what rules "
     "it out, the reason in millimetres and degrees, the nearest place that can be reached.",
     "print(explain(xyz(1m, 0m, 0m)))", explain_place},
    {"reachable", "(r: robot, p: posC) -> bool",
     "Whether the tool point can get to p within the joint limits.", "reachable(xyz(1m, 0m, 0m))",
     reachable},
};

}  // namespace

std::span<const NativeFunction> ikine_functions() { return kIkineFunctions; }

}  // namespace armlet::bind
