// Robots from Denavit-Hartenberg tables, and the names of the 2011 platform for them: new Robot(dh,
// types, limits), robot.DHTable, robot.forwardKinematics, robot.IKinematics (language reference,
// 13.1 and 18).

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_limits.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "moves/moves.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/robots/give.hpp"
#include "values/robots/models.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Rows = std::span<const Slot>;  // of numbers

std::vector<std::vector<double>> rows_of(Rows table) {
  std::vector<std::vector<double>> rows;
  for (const Slot row : table) {
    const auto values = reals_value(row);
    rows.emplace_back(values.begin(), values.end());
  }
  return rows;
}

// A word such as "RRPR", or one text for each joint.
using Word = std::string_view;
using Letters = std::span<const Slot>;
std::string kinds_of(Word types) { return std::string(types); }
std::string kinds_of(Letters types) {
  std::string word;
  for (const Slot letter : types) {
    const std::string_view text = text_value(letter);
    word += text.size() == 1 ? text : std::string_view("?");
  }
  return word;
}

template <class Types>
Answer<RobotRef> robot_from_table(Vm& vm, Rows table, Types types, std::optional<Rows> limits,
                                  std::string_view convention, const PosC* base,
                                  const ToolValue* tool, std::optional<std::string_view> name) try {
  RobotSpec spec;
  if (name) spec.name = *name;
  spec.source = "a table in the program";
  spec.convention = convention_of(convention);
  spec.joints = joints_from_table(rows_of(table), kinds_of(types));
  if (limits) set_limits(spec.joints, rows_of(*limits));
  return add_robot(vm, finished(Robot(std::move(spec)), base, tool));
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0630"), error);
}

// ---- the names of the platform

std::vector<std::vector<double>> dh_rows(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < robot.rows(); ++i) {
    const DhRow& row = robot.row(i).dh;
    rows.push_back({row.theta, row.d, row.a, row.alpha});
  }
  return rows;
}

template <class Q>
Answer<PosC> forward_kinematics(Vm& vm, const RobotRef& r, Q values) {
  return at_joints<PosC>(vm, r, values, [](const Robot& robot, const auto& q) {
    return PosC{forward(robot, q), true};
  });
}

// asked  the argument that messages about the position mark.
template <class Q>
Answer<PosJ> inverse_of(Vm& vm, const RobotRef& r, Q q0, const PosC& p, CallPart asked) {
  const Robot& robot = model_of(vm, r);
  const auto start = joint_argument(vm, robot, q0, at("q0"));
  if (!start) return Failed{};
  const auto q = solve_target(
      vm, {.function = "IKinematics", .robot = r.id, .target = asked, .moves = false}, p, *start);
  if (!q) return Failed{};
  return make_posj(robot, *q);
}

template <class Q>
Answer<PosJ> inverse_from_position(Vm& vm, const RobotRef& r, Q q0, const PosC& p) {
  return inverse_of<Q>(vm, r, q0, p, at("p"));
}

template <class Q>
Answer<PosJ> inverse_from_numbers(Vm& vm, const RobotRef& r, Q q0, double x, double y, double z,
                                  std::optional<double> roll) {
  static constexpr CallPart kCoordinates[] = {at("X"), at("Y"), at("Z")};
  const Eigen::Vector3d p(x, y, z);
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(p[i])) return not_finite(vm, "a coordinate", p[i], kCoordinates[i]);
  }
  if (!roll) return inverse_of<Q>(vm, r, q0, {make_translation(p), false}, at("X"));
  if (!std::isfinite(*roll)) return not_finite(vm, "the angle", *roll, at("Roll"));
  const PosC target{make_pose(rot_z(*roll), p), true};
  if (task_of(model_of(vm, r), target) == IkTask::kPose) {
    return failure(vm, "R0613",
                   fmt::format("X, Y, Z and Roll do not say how the tool of `{}` is tilted",
                               state_of(vm, r).name),
                   at("Roll"),
                   "they are enough for an arm whose tool keeps its tilt, such as a SCARA",
                   "give a whole position: IKinematics(q0, pose(x: ..., roll: ...))");
  }
  return inverse_of<Q>(vm, r, q0, target, at("X"));
}

constexpr std::string_view kFromTable =
    "A robot from a table with rows theta, d, a, alpha (rad, m), an R or P for each joint, and a "
    "lower and an upper limit for each (rad, m; -360 to 360 deg and 0 to 1 m without them).";
constexpr std::string_view kPlatformRobot =
    "A robot as the 2011 platform makes it; the same as dh. Robot is another name of the type "
    "robot.";
constexpr std::string_view kForward =
    "Where the tool point is for these joint values: the platform's name of fkine.";
constexpr std::string_view kInverse =
    "Joint values near q0 that bring the tool point to X, Y, Z, turned by Roll about z where it "
    "is given: the platform's name of ikine.";
constexpr std::string_view kInversePosition =
    "Joint values near q0 that bring the tool point to p.";
constexpr CallOptions kOfTable{
    .check = check_all_of<check_word<"convention", kConventions>, check_dh_table>};
constexpr CallOptions kNearList{.check = check_joint_list<"q0">};

constexpr NativeFunction kDhFunctions[] = {
    def<robot_from_table<Word>, robot_from_table<Letters>>(
        "dh(table: double[][], types: string | string[], limits: double[][]?, convention: string = "
        "\"standard\", base: posC?, tool: tool?, name: string?) -> robot",
        kFromTable, "dh([[0.0, 0.0, 0.3, 0.0]], types: \"R\", limits: [[-1.5, 1.5]])", kOfTable),
    def<robot_from_table<Word>, robot_from_table<Letters>>(
        "Robot(table: double[][], types: string | string[], limits: double[][]?, convention: "
        "string = \"standard\", base: posC?, tool: tool?, name: string?) -> robot",
        kPlatformRobot, "new Robot([[0.0, 0.0, 0.3, 0.0]], \"R\", [[-1.5, 1.5]])", kOfTable),
    def<dh_rows>("robot.DHTable(r: robot) -> double[][]",
                 "The Denavit-Hartenberg table as lists, one row theta, d, a, alpha for each "
                 "joint, in rad and "
                 "m.",
                 "robots.scara().DHTable"),
    def<forward_kinematics<Joints>, forward_kinematics<JointList>>(
        "robot.forwardKinematics(r: robot, q: posJ | double[]) -> posC", kForward,
        "robots.scara().forwardKinematics(posJ(20deg, 30deg, 100mm, 0deg))",
        {.check = check_joint_list<"q">}),
    def<inverse_from_numbers<Joints>, inverse_from_numbers<JointList>>(
        "robot.IKinematics(r: robot, q0: posJ | double[], X: double, Y: double, Z: double, Roll: "
        "double?) -> posJ",
        kInverse,
        "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), 0.5, 0.2, 0.25, 0.0)",
        kNearList),
    def<inverse_from_numbers<Joints>, inverse_from_numbers<JointList>>(
        "robot.IKinematics(r: robot, q0: posJ | double[], X: length, Y: length, Z: length, Roll: "
        "angle?) -> posJ",
        kInverse,
        "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), 500mm, 200mm, 250mm, 0deg)",
        kNearList),
    def<inverse_from_position<Joints>, inverse_from_position<JointList>>(
        "robot.IKinematics(r: robot, q0: posJ | double[], p: posC) -> posJ", kInversePosition,
        "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), xyz(500mm, 200mm, 250mm))",
        kNearList),
};

}  // namespace

std::span<const NativeFunction> dh_functions() { return kDhFunctions; }

}  // namespace armlet::bind
