// Robots from Denavit-Hartenberg tables, and the names of the 2011 platform for them: new Robot(dh,
// types, limits), robot.DHTable, robot.forwardKinematics, robot.IKinematics (language reference,
// 13.1 and 18).

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_limits.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "give.hpp"
#include "models.hpp"
#include "moves.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

std::vector<std::vector<double>> rows_of(Slot table) {
  std::vector<std::vector<double>> rows;
  for (const Slot row : items_value(table)) {
    const auto values = reals_value(row);
    rows.emplace_back(values.begin(), values.end());
  }
  return rows;
}

// A word such as "RRPR", or one text for each joint.
template <bool kTexts>
std::string kinds_of(Slot types) {
  if constexpr (!kTexts) return std::string(text_value(types));
  std::string word;
  for (const Slot letter : items_value(types)) {
    const std::string_view text = text_value(letter);
    word += text.size() == 1 ? text : std::string_view("?");
  }
  return word;
}

// (table, types, limits, convention, base, tool, name)
template <bool kTexts>
Signal robot_from_table(Vm& vm, Slot* args) try {
  enum { kTable, kTypes, kLimits, kConvention, kBase, kTool, kName };
  RobotSpec spec;
  if (args[kName].o != nullptr) spec.name = std::string(text_value(args[kName]));
  spec.source = "a table in the program";
  spec.convention = convention_of(text_value(args[kConvention]));
  spec.joints = joints_from_table(rows_of(args[kTable]), kinds_of<kTexts>(args[kTypes]));
  if (args[kLimits].o != nullptr) set_limits(spec.joints, rows_of(args[kLimits]));
  return add_robot(vm, args,
                   finished(Robot(std::move(spec)), args[kBase], args[kTool], Slot{.o = nullptr}));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error);
}

// ---- the names of the platform

Signal dh_rows(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  std::vector<DhRow> rows;
  for (int i = 0; i < robot.n(); ++i) rows.push_back(robot.joint(i).dh);
  return give_objects<DhRow>(vm, args, rows, [](Vm& machine, const DhRow& row) {
    const double values[] = {row.theta, row.d, row.a, row.alpha};
    return new_reals(machine, values);
  });
}

template <bool kList>
Signal forward_kinematics(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  return give(args, new_posc(vm, {forward(robot, *q), true}));
}

// (r, q0, X, Y, Z, Roll)
enum Asked { kRobotAsked, kStart, kX, kY, kZ, kRoll };

Signal solve_from(Vm& vm, Slot* args, bool is_list, const PosC& target) {
  const Robot& robot = *state_of(vm, args[kRobotAsked]).model;
  const MoveCall call{
      .function = "IKinematics", .robot = robot_id(args[kRobotAsked]), .target = kX};
  const auto start = joint_argument(vm, robot, args[kStart], is_list, kStart);
  if (!start) return Signal::kFail;
  auto q = solve_target(vm, call, target, *start);
  return q ? give(args, new_posj(vm, make_posj(robot, *q))) : Signal::kFail;
}

template <bool kList>
Signal inverse_from_numbers(Vm& vm, Slot* args) {
  for (int i = kX; i <= kZ; ++i) {
    if (!std::isfinite(args[i].d)) return not_finite(vm, "a coordinate", args[i].d, i);
  }
  const Eigen::Vector3d p(args[kX].d, args[kY].d, args[kZ].d);
  if (is_absent(args[kRoll])) return solve_from(vm, args, kList, {make_translation(p), false});
  const double roll = args[kRoll].d;
  if (!std::isfinite(roll)) return not_finite(vm, "the angle", roll, kRoll);
  const PosC target{make_pose(rot_z(roll), p), true};
  const Robot& robot = *state_of(vm, args[kRobotAsked]).model;
  if (task_of(robot, target) == IkTask::kPose) {
    return failure(vm, "R0613",
                   fmt::format("X, Y, Z and Roll do not say how the tool of `{}` is tilted",
                               state_of(vm, args[kRobotAsked]).name),
                   kRoll, "they are enough for an arm whose tool keeps its tilt, such as a SCARA",
                   "give a whole position: IKinematics(q0, pose(x: ..., roll: ...))");
  }
  return solve_from(vm, args, kList, target);
}

template <bool kList>
Signal inverse_from_position(Vm& vm, Slot* args) {
  return solve_from(vm, args, kList, posc(args[kX]));
}

constexpr std::string_view kFromTable =
    "A robot from a table with rows theta, d, a, alpha (rad, m), an R or P for each joint, and a "
    "lower and an upper limit for each (rad, m; -360 to 360 deg and 0 to 1 m without them).";
constexpr std::string_view kPlatformRobot =
    "A robot as the 2011 platform makes it; the same as dh. Robot is another name of the type "
    "robot.";
constexpr std::string_view kWord =
    "(table: double[][], types: string, limits: double[][]?, convention: string = \"standard\", "
    "base: posC?, tool: tool?, name: string?) -> robot";
constexpr std::string_view kTexts =
    "(table: double[][], types: string[], limits: double[][]?, convention: string = "
    "\"standard\", base: posC?, tool: tool?, name: string?) -> robot";
constexpr std::string_view kForward =
    "Where the tool point is for these joint values: the platform's name of fkine.";
constexpr std::string_view kInverse =
    "Joint values near q0 that bring the tool point to X, Y, Z, turned by Roll about z where it "
    "is given: the platform's name of ikine.";
constexpr std::string_view kInversePosition =
    "Joint values near q0 that bring the tool point to p.";
constexpr auto kNearList = check_joint_list<1>;

constexpr NativeFunction kDhFunctions[] = {
    {"dh", kWord, kFromTable, "dh([[0.0, 0.0, 0.3, 0.0]], types: \"R\", limits: [[-1.5, 1.5]])",
     robot_from_table<false>, nullptr, nullptr, check_dh_table},
    {"dh", kTexts, kFromTable, "dh([[0.0, 0.0, 0.3, 0.0]], types: [\"R\"], limits: [[-1.5, 1.5]])",
     robot_from_table<true>, nullptr, nullptr, check_dh_table},
    {"Robot", kWord, kPlatformRobot, "new Robot([[0.0, 0.0, 0.3, 0.0]], \"R\", [[-1.5, 1.5]])",
     robot_from_table<false>, nullptr, nullptr, check_dh_table},
    {"Robot", kTexts, kPlatformRobot, "new Robot([[0.0, 0.0, 0.3, 0.0]], [\"R\"], [[-1.5, 1.5]])",
     robot_from_table<true>, nullptr, nullptr, check_dh_table},
    {"robot.DHTable", "(r: robot) -> double[][]",
     "The Denavit-Hartenberg table as lists, one row theta, d, a, alpha for each joint, in rad and "
     "m.",
     "robots.scara().DHTable", dh_rows},
    {"robot.forwardKinematics", "(r: robot, q: posJ) -> posC", kForward,
     "robots.scara().forwardKinematics(posJ(20deg, 30deg, 100mm, 0deg))",
     forward_kinematics<false>},
    {"robot.forwardKinematics", "(r: robot, q: double[]) -> posC", kForward,
     "robots.scara().forwardKinematics([0.0, 0.0, 0.1, 0.0])", forward_kinematics<true>, nullptr,
     nullptr, kNearList},
    {"robot.IKinematics",
     "(r: robot, q0: posJ, X: double, Y: double, Z: double, Roll: double?) -> posJ", kInverse,
     "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), 0.5, 0.2, 0.25, 0.0)",
     inverse_from_numbers<false>},
    {"robot.IKinematics",
     "(r: robot, q0: double[], X: double, Y: double, Z: double, Roll: double?) -> posJ", kInverse,
     "robots.scara().IKinematics([0.0, 0.5, 0.1, 0.0], 0.5, 0.2, 0.25, 0.0)",
     inverse_from_numbers<true>, nullptr, nullptr, kNearList},
    {"robot.IKinematics",
     "(r: robot, q0: posJ, X: length, Y: length, Z: length, Roll: angle?) -> posJ", kInverse,
     "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), 500mm, 200mm, 250mm, 0deg)",
     inverse_from_numbers<false>},
    {"robot.IKinematics",
     "(r: robot, q0: double[], X: length, Y: length, Z: length, Roll: angle?) -> posJ", kInverse,
     "robots.scara().IKinematics([0.0, 0.5, 0.1, 0.0], 500mm, 200mm, 250mm, 0deg)",
     inverse_from_numbers<true>, nullptr, nullptr, kNearList},
    {"robot.IKinematics", "(r: robot, q0: posJ, p: posC) -> posJ", kInversePosition,
     "robots.scara().IKinematics(posJ(20deg, 30deg, 100mm, 0deg), xyz(500mm, 200mm, 250mm))",
     inverse_from_position<false>},
    {"robot.IKinematics", "(r: robot, q0: double[], p: posC) -> posJ", kInversePosition,
     "robots.scara().IKinematics([0.0, 0.5, 0.1, 0.0], xyz(500mm, 200mm, 250mm))",
     inverse_from_position<true>, nullptr, nullptr, kNearList},
};

}  // namespace

std::span<const NativeFunction> dh_functions() { return kDhFunctions; }

}  // namespace armlet::bind
