// Inverse kinematics and its explanations (language reference, section 13.6).

#include <fmt/format.h>

#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/stdlib/host.hpp"
#include "moves/move_failures.hpp"
#include "moves/moves.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/robots/give.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

using Mask = std::optional<std::span<const Slot>>;
using OptionalWord = std::optional<std::string_view>;

Answer<void> read_mask(Vm& vm, Mask mask, IkOptions& options) {
  if (!mask) return {};
  if (mask->size() != 6) {
    return failure(vm, "R0613", fmt::format("a mask has 6 values, not {}", mask->size()),
                   at("mask"),
                   "they stand for x, y, z and the turns about x, y, z: 1 counts, 0 does not");
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const std::int64_t value = (*mask)[i].i;
    if (value != 0 && value != 1) {
      return failure(vm, "R0609", fmt::format("a mask of {}: its values are 1 or 0", value),
                     at("mask"), "1 counts, 0 does not",
                     "to keep the place only: mask: [1, 1, 1, 0, 0, 0]");
    }
    options.mask[i] = value == 1;
  }
  options.task = IkTask::kMasked;
  return {};
}

Answer<void> read_axes(Vm& vm, std::string_view axes, IkOptions& options) {
  if (axes == "tool") options.mask_frame = IkMaskFrame::kTool;
  if (axes == "tool" || axes == "world") return {};
  return failure(vm, "R0626", fmt::format("a mask has no axes \"{}\"", axes), at("axes"),
                 "its axes are those of the \"world\" or of the \"tool\"");
}

Answer<void> read_posture(Vm& vm, const Robot& robot, const PosJ& values, IkOptions& options) {
  auto q = joint_argument(vm, robot, values, at("posture"));
  if (!q) return Failed{};
  options.posture.emplace(Posture::kNearGiven, *std::move(q));
  return {};
}
Answer<void> read_posture(Vm& vm, const Robot&, OptionalWord word, IkOptions& options) {
  if (!word) return {};
  if (*word == "midRange") options.posture = Posture::kMidRange;
  if (*word == "manipulability") options.posture = Posture::kManipulability;
  if (options.posture) return {};
  return failure(
      vm, "R0626", fmt::format("there is no posture called \"{}\"", *word), at("posture"),
      "\"midRange\" keeps the joints in the middle of their ranges, \"manipulability\" keeps away "
      "from singularities",
      "use one of these, or give joint values to stay near: posture: home()");
}

// A problem of inverse kinematics: the goal and the options.
struct Question {
  Eigen::Isometry3d T_world_tool;
  IkOptions options;
  bool tilted = false;  // an orientation that this arm cannot have for any joint values
};

// The arguments of ikine and of explain(ikine(...)).
template <class Near, class PostureGiven>
struct Call {
  const RobotRef& r;
  const PosC& p;
  Near near;
  Mask mask;
  std::string_view axes;
  PostureGiven posture;
};

template <class Near, class PostureGiven>
Answer<Question> question_of(Vm& vm, const Call<Near, PostureGiven>& call) {
  const Robot& robot = model_of(vm, call.r);
  Question out{.T_world_tool = call.p.T};
  IkOptions& options = out.options;
  auto seed = seed_of(vm, call.r, call.near, at("near"));
  if (!seed) return Failed{};
  options.seed = *std::move(seed);
  const auto task = task_of(robot, call.p);
  if (task) options.task = *task;
  if (!read_mask(vm, call.mask, options) || !read_axes(vm, call.axes, options) ||
      !read_posture(vm, robot, call.posture, options))
    return Failed{};
  out.tilted = !task && options.task != IkTask::kMasked;
  // For a position without orientation the present orientation is kept.
  if (options.task == IkTask::kMasked && !call.p.has_orientation)
    out.T_world_tool.linear() = forward(robot, options.seed).linear();
  if (options.task == IkTask::kMasked && task == IkTask::kHeading)
    out.T_world_tool = with_heading_of(robot, call.p.T, options.seed);
  return out;
}

template <class Near, class PostureGiven>
Answer<PosJ> ikine(Vm& vm, const RobotRef& r, const PosC& p, Near near, Mask mask,
                   std::string_view axes, PostureGiven posture) {
  const auto question = question_of(vm, Call<Near, PostureGiven>{r, p, near, mask, axes, posture});
  if (!question) return Failed{};
  const MoveCall call{.function = "ikine", .robot = r.id, .target = at("p")};
  if (question->tilted) return fail_tilted(vm, call, p);
  const Robot& robot = model_of(vm, r);
  const IkResult result = solve_ik(robot, question->T_world_tool, question->options);
  if (!result.ok()) return fail_unreachable(vm, call, question->T_world_tool, result);
  return make_posj(robot, result.q);
}

std::string report_of(Vm& vm, const RobotRef& r, const Question& question) {
  const CellRobot& state = state_of(vm, r);
  const Robot& robot = *state.model;
  if (question.tilted) return fmt::format("{}: {}", state.name, tilt_reason(robot));
  return to_text(robot, question.T_world_tool,
                 report_ik(robot, question.T_world_tool, question.options));
}

template <class Near, class PostureGiven>
Answer<std::string> explain_ikine(Vm& vm, const RobotRef& r, const PosC& p, Near near, Mask mask,
                                  std::string_view axes, PostureGiven posture) {
  const auto question = question_of(vm, Call<Near, PostureGiven>{r, p, near, mask, axes, posture});
  if (!question) return Failed{};
  return report_of(vm, r, *question);
}

std::string explain_position(Vm& vm, const RobotRef& r, const PosC& p) {
  const CellRobot& state = state_of(vm, r);
  const auto task = task_of(*state.model, p);
  Question question{.T_world_tool = p.T, .tilted = !task};
  question.options.seed = state.q;
  question.options.task = task.value_or(IkTask::kPose);
  return report_of(vm, r, question);
}

// Explains how the pose of these joint values is solved with them as the seed.
Answer<std::string> explain_joints(Vm& vm, const RobotRef& r, const PosJ& values) {
  const Robot& robot = model_of(vm, r);
  const auto q = joint_argument(vm, robot, values, at("q"));
  if (!q) return Failed{};
  Question question{.T_world_tool = forward(robot, *q)};
  question.options.seed = *q;
  return report_of(vm, r, question);
}

std::vector<PosJ> ikine_all(Vm& vm, const RobotRef& r, const PosC& p, bool limits) {
  const CellRobot& robot = state_of(vm, r);
  std::vector<PosJ> list;
  if (const auto task = task_of(*robot.model, p)) {
    IkOptions options;
    options.seed = robot.q;
    options.task = *task;
    options.respect_limits = limits;
    for (const Eigen::VectorXd& q : solve_ik_all(*robot.model, p.T, options))
      list.push_back(make_posj(*robot.model, q));
  }
  return list;
}

bool reachable(Vm& vm, const RobotRef& r, const PosC& p) {
  const CellRobot& robot = state_of(vm, r);
  const auto task = task_of(*robot.model, p);
  if (!task) return false;
  IkOptions options;
  options.seed = robot.q;
  options.task = *task;
  options.diagnose = false;
  return solve_ik(*robot.model, p.T, options).ok();
}

constexpr NativeFunction kIkineFunctions[] = {
    def<ikine<const PosJ*, OptionalWord>>(
        "ikine(r: robot, p: posC, near: posJ?, mask: int[]?, axes: string = \"world\", posture: "
        "string?) -> posJ",
        "Joint values that bring the tool point to p, the ones nearest to `near` (the present "
        "ones). mask: which of x, y, z and the turns about x, y, z count (1) or do not (0), along "
        "the axes of the \"world\" or the \"tool\". posture: of all joint values that get there "
        "the ones nearest to the middle of the joints' ranges (\"midRange\") or farthest from "
        "singularities (\"manipulability\").",
        "ikine(here(), posture: \"midRange\")",
        {.check = check_all_of<check_word<"axes", kMaskAxes>, check_word<"posture", kPostures>,
                               note_positions>,
         .explain = explained_by<explain_ikine<const PosJ*, OptionalWord>>}),
    def<ikine<const PosJ*, Joints>>(
        "ikine(r: robot, p: posC, near: posJ?, mask: int[]?, axes: string = \"world\", posture: "
        "posJ) -> posJ",
        "Of all joint values that bring the tool point to p the ones nearest to a posture, every "
        "joint counted by its range.",
        "ikine(here(), posture: home())",
        {.check = check_all_of<check_word<"axes", kMaskAxes>, note_positions>,
         .explain = explained_by<explain_ikine<const PosJ*, Joints>>}),
    def<ikine<JointList, OptionalWord>>(
        "ikine(r: robot, p: posC, near: double[], mask: int[]?, axes: string = \"world\", posture: "
        "string?) -> posJ",
        "Joint values that bring the tool point to p, near joint values in rad and m.",
        "ikine(here(), near: [0.0, 0.5, 0.1, 0.0])",
        {.check = check_all_of<check_joint_list<"near">, check_word<"axes", kMaskAxes>,
                               check_word<"posture", kPostures>, note_positions>,
         .explain = explained_by<explain_ikine<JointList, OptionalWord>>}),
    def<ikine<JointList, Joints>>(
        "ikine(r: robot, p: posC, near: double[], mask: int[]?, axes: string = \"world\", posture: "
        "posJ) -> posJ",
        "Joint values that bring the tool point to p, near joint values in rad and m and near a "
        "posture.",
        "ikine(here(), near: [0.0, 0.5, 0.1, 0.0], posture: home())",
        {.check =
             check_all_of<check_joint_list<"near">, check_word<"axes", kMaskAxes>, note_positions>,
         .explain = explained_by<explain_ikine<JointList, Joints>>}),
    def<ikine_all>(
        "ikineAll(r: robot, p: posC, limits: bool = true) -> posJ[]",
        "All joint values that bring the tool point to p, the nearest to the present ones first: "
        "every branch of an arm with a closed form; limits: false lists those beyond the joint "
        "limits too. An empty list if there are none. A place without orientation keeps the "
        "present one as far as the arm can; an arm that cannot turn its tool by itself lists every "
        "way to the place.",
        "ikineAll(here())"),
    def<explain_joints>(
        "explain(r: robot, q: posJ) -> string",
        "How inverse kinematics comes to these joint values: the solver and why, every branch with "
        "what rules it out. explain(ikine(p)) says the same of a call of ikine, with its settings, "
        "and where there is no solution, why, and the nearest place that can be reached.",
        "print(explain(ikine(xyz(2m, 0m, 300mm))))"),
    def<explain_position>(
        "explain(r: robot, p: posC) -> string",
        "How inverse kinematics solves p, or why it cannot: the solver, every branch with what "
        "rules it out, the reason in millimetres and degrees, the nearest place that can be "
        "reached.",
        "print(explain(xyz(1m, 0m, 0m)))"),
    def<reachable>("reachable(r: robot, p: posC) -> bool",
                   "Whether the tool point can get to p within the joint limits.",
                   "reachable(xyz(1m, 0m, 0m))"),
};

}  // namespace

std::span<const NativeFunction> ikine_functions() { return kIkineFunctions; }

}  // namespace armlet::bind
