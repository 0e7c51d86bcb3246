// The state of robots and their kinematics (language reference, sections 13.6 and 19).

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/robots/give.hpp"
#include "values/robots/models.hpp"
#include "values/robots/robot_state.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

PosJ joints(Vm& vm, const RobotRef& r) { return make_posj(model_of(vm, r), state_of(vm, r).q); }
Eigen::VectorXd joint_speeds(Vm& vm, const RobotRef& r) { return state_of(vm, r).qd; }
Eigen::VectorXd joint_accels(Vm& vm, const RobotRef& r) { return state_of(vm, r).qdd; }
PosC here(Vm& vm, const RobotRef& r) { return {Host::of(vm).cell().T_world_tool(r.id), true}; }
Vector6d tcp_speed(Vm& vm, const RobotRef& r) {
  const CellRobot& own = state_of(vm, r);
  const CellRobot& robot = own.on < 0 ? own : Host::of(vm).cell().robot(own.on);
  return jacobian(*robot.model, robot.q) * robot.qd;
}
bool moving(Vm& vm, const RobotRef& r) { return Host::of(vm).cell().is_moving(r.id); }
PosJ home(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  return make_posj(robot, robot.home());
}
RecordObj* force(Vm& vm, const RobotRef& r, bool load) {
  const Cell& cell = Host::of(vm).cell();
  Vector6d wrench = cell.contact_wrench(r.id);
  if (load) wrench += cell.held_wrench(r.id);
  RecordObj* record = new_record(vm, vm.program().library_record("Wrench"));
  for (int i = 0; record != nullptr && i < 6; ++i) record->fields()[i].d = wrench[i];
  return record;
}

std::int64_t dof(Vm& vm, const RobotRef& r) { return model_of(vm, r).n(); }
std::string name(Vm& vm, const RobotRef& r) { return state_of(vm, r).name; }
std::string types(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  std::string word;
  for (int i = 0; i < robot.n(); ++i) word += robot.is_revolute(i) ? 'R' : 'P';
  return word;
}

std::vector<PosJ> limits(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  return {make_posj(robot, robot.lower()), make_posj(robot, robot.upper())};
}

// ---- changing a robot ---------------------------------------------------------------------------

Answer<void> set_tool(Vm& vm, const RobotRef& r, const PosC& tcp) {
  return exchange_model(vm, r, at("tcp"),
                        [&](const Robot& robot) { return robot.with_tool_point(tcp.T); });
}
Answer<void> set_home(Vm& vm, const RobotRef& r, const PosJ& q) {
  return exchange_model(vm, r, at("q"),
                        [&](const Robot& robot) { return robot.with_home(q.vector()); });
}

// ---- kinematics ---------------------------------------------------------------------------------

template <class Q>
Answer<PosC> fkine(Vm& vm, const RobotRef& r, Q values, std::optional<std::int64_t> joint) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto q = joint_argument(vm, robot, values, at("q"));
  if (!q) return Failed{};
  if (!joint) return PosC{forward(robot, *q), true};
  if (*joint < 1 || *joint > robot.rows())
    return failure(vm, "R0606", fmt::format("joint {} is outside 1 to {}", *joint, robot.rows()),
                   at("joint"));
  return PosC{link_frame(robot, *q, static_cast<int>(*joint)), true};
}

template <class Q>
Answer<std::vector<PosC>> link_frames(Vm& vm, const RobotRef& r, Q values) {
  return at_joints<std::vector<PosC>>(vm, r, values, [](const Robot& robot, const auto& q) {
    std::vector<PosC> frames;
    for (const Eigen::Isometry3d& T : armlet::link_frames(robot, q)) frames.push_back({T, true});
    return frames;
  });
}

template <class Q>
Answer<double> manipulability_of(Vm& vm, const RobotRef& r, Q values) {
  return at_joints<double>(vm, r, values, manipulability);
}

template <class Q>
Answer<Jacobian> jacobian_of(Vm& vm, const RobotRef& r, Q values, std::string_view name) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto q = joint_argument(vm, robot, values, at("q"));
  if (!q) return Failed{};
  const auto frame = name == "world"  ? std::optional(JacobianFrame::kWorld)
                     : name == "base" ? std::optional(JacobianFrame::kBase)
                     : name == "tool" ? std::optional(JacobianFrame::kTool)
                                      : std::nullopt;
  if (!frame) {
    return failure(vm, "R0626", fmt::format("a Jacobian has no frame \"{}\"", name), at("frame"),
                   "its frames are \"world\", \"base\" and \"tool\"");
  }
  return jacobian(robot, *q, *frame);
}

template <class Q, class Rates>
Answer<Vector6d> jacobian_dot(Vm& vm, const RobotRef& r, Q values, Rates rates) {
  return at_joint_speeds<Vector6d>(vm, r, values, rates, jacobian_dot_qd);
}

template <class Q>
Answer<Jacobian> jacobian_rate_of(Vm& vm, const RobotRef& r, Q values, JointList rates) {
  return at_joint_speeds<Jacobian>(vm, r, values, rates,
                                   [](const Robot& robot, const auto& q, const auto& qd) {
                                     return jacobian_rate(robot, q, qd);
                                   });
}

Eigen::MatrixXd dh_table(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  Eigen::MatrixXd table(robot.rows(), 4);
  for (int i = 0; i < robot.rows(); ++i) {
    const DhRow& row = robot.row(i).dh;
    table.row(i) << row.theta, row.d, row.a, row.alpha;
  }
  return table;
}

PosJ random_joints(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] = robot.joint(i).is_continuous() ? vm.random().uniform(-kPi, kPi)
                                          : vm.random().uniform(robot.lower()[i], robot.upper()[i]);
  return make_posj(robot, q);
}

constexpr std::string_view kFrames = "The frames after each joint.";
constexpr std::string_view kManipulability = "Yoshikawa's measure: zero where the arm is singular.";
constexpr std::string_view kJacobian =
    "Maps joint speeds to the velocity of the tool point: three rows in m/s, three in rad/s, along "
    "the axes of the frame \"world\", \"base\" or \"tool\".";
constexpr std::string_view kJacobianRate =
    "The rate of change of the Jacobian while the joints move with qd, in the world's axes.";
constexpr std::string_view kJacobianDot =
    "The acceleration of the tool point that the joint speeds qd cause while they do not change: "
    "the rate of the Jacobian times qd, three values in m/s^2 and three in rad/s^2, in the world.";

constexpr NativeFunction kRobotFunctions[] = {
    def<joints>("joints(r: robot) -> posJ", "The joint values now.", "joints()",
                {.check = note_positions}),
    def<joint_speeds>("jointSpeeds(r: robot) -> double[]", "The joint speeds now, rad/s and m/s.",
                      "jointSpeeds()", {.check = note_speeds}),
    def<joint_accels>("jointAccels(r: robot) -> double[]",
                      "The joint accelerations now, rad/s^2 and m/s^2.", "jointAccels()",
                      {.check = note_accels}),
    def<here>("here(r: robot) -> posC", "The tool point now, in the world.", "here()"),
    def<tcp_speed>("tcpSpeed(r: robot) -> double[]",
                   "The velocity of the tool point: vx, vy, vz in m/s and wx, wy, wz in rad/s.",
                   "tcpSpeed()", {.check = note_twist}),
    def<force>("force(r: robot, load: bool = false) -> Wrench",
               "What the surroundings exert on the tool point, in the axes of the world; with load "
               "also what the hand holds does, by its weight and as it is moved.",
               "force().z"),
    def<moving>("moving(r: robot) -> bool", "Whether the robot is on its way.", "moving()"),
    def<home>("home(r: robot) -> posJ", "The home position.", "moveJ(home(), time: 2s)",
              {.check = note_positions}),
    def<dof>("robot.dof(r: robot) -> int", "The number of joints.", "robots.scara().dof"),
    def<name>("robot.name(r: robot) -> string", "The name.", "robots.scara().name"),
    def<types>("robot.types(r: robot) -> string", "One letter per joint: R turns, P slides.",
               "robots.scara().types"),
    def<limits>("limits(r: robot) -> posJ[]", "The lower and the upper joint limits.", "limits()"),
    def<set_tool>("setTool(r: robot, tcp: posC)",
                  "Moves the tool point, seen from the flange; the hand stays.",
                  "setTool(xyz(z: 50mm))", {.commands = true}),
    def<set_home>("setHome(r: robot, q: posJ)", "Changes the home position.", "setHome(joints())",
                  {.check = check_joints_of<"q">}),
    def<fkine<Joints>, fkine<JointList>>(
        "fkine(r: robot, q: posJ | double[], joint: int?) -> posC",
        "Where the tool point is for these joint values; with joint: the frame after that joint, "
        "counted from 1.",
        "fkine(joints()); fkine([0.0, 0.0, 0.1, 0.0])", {.check = check_joint_list<"q">}),
    def<link_frames<Joints>, link_frames<JointList>>(
        "linkFrames(r: robot, q: posJ | double[]) -> posC[]", kFrames,
        "linkFrames(joints()); linkFrames([0.0, 0.0, 0.1, 0.0])", {.check = check_joint_list<"q">}),
    def<manipulability_of<Joints>, manipulability_of<JointList>>(
        "manipulability(r: robot, q: posJ | double[]) -> double", kManipulability,
        "manipulability(joints()); manipulability([0.0, 0.5, 0.1, 0.0])",
        {.check = check_joint_list<"q">}),
    def<jacobian_of<Joints>, jacobian_of<JointList>>(
        "jacobian(r: robot, q: posJ | double[], frame: string = \"world\") -> matrix", kJacobian,
        "jacobian(joints()); jacobian([0.0, 0.5, 0.1, 0.0], frame: \"tool\")",
        {.check = check_all_of<check_joint_list<"q">, check_word<"frame", kJacobianFrames>>}),
    def<jacobian_dot<Joints, JointList>, jacobian_dot<Joints, Joints>,
        jacobian_dot<JointList, JointList>, jacobian_dot<JointList, Joints>>(
        "jacobianDot(r: robot, q: posJ | double[], qd: double[] | posJ) -> double[]", kJacobianDot,
        "jacobianDot(joints(), jointSpeeds())",
        {.check = check_all_of<check_joint_list<"q">, note_twist_rate>}),
    def<jacobian_rate_of<Joints>, jacobian_rate_of<JointList>>(
        "jacobianRate(r: robot, q: posJ | double[], qd: double[]) -> matrix", kJacobianRate,
        "jacobianRate(joints(), jointSpeeds()); jacobianRate([0.0, 0.5, 0.1, 0.0], [0.1, 0.2, 0.0, "
        "0.3])",
        {.check = check_joint_list<"q">}),
    def<dh_table>("dhTable(r: robot) -> matrix",
                  "The Denavit-Hartenberg parameters, one row theta, d, a, alpha for each joint, "
                  "in rad and m.",
                  "dhTable()", {.check = note_dh_table}),
    def<random_joints>("randomJoints(r: robot) -> posJ",
                       "Joint values drawn evenly within the limits; the same ones in every run.",
                       "randomJoints()", {.check = note_positions}),
};

}  // namespace

std::span<const NativeFunction> robot_functions() { return kRobotFunctions; }

}  // namespace armlet::bind
