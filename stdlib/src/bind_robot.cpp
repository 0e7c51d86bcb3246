// The state of robots and their kinematics (language reference, section 19).

#include <fmt/format.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "give.hpp"
#include "moves.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

Signal joints(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[0]);
  return give(args, new_posj(vm, make_posj(*robot.model, robot.q)));
}
Signal joint_speeds(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[0]);
  return give(args, new_reals(vm, {robot.qd.data(), static_cast<std::size_t>(robot.qd.size())}));
}
Signal joint_accels(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[0]);
  return give(args, new_reals(vm, {robot.qdd.data(), static_cast<std::size_t>(robot.qdd.size())}));
}
Signal here(Vm& vm, Slot* args) {
  return give(args, new_posc(vm, {Host::of(vm).cell().T_world_tool(robot_id(args[0])), true}));
}
Signal tcp_speed(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[0]);
  const Eigen::Matrix<double, 6, 1> twist = jacobian(*robot.model, robot.q) * robot.qd;
  return give(args, new_reals(vm, {twist.data(), 6}));
}
Signal moving(Vm& vm, Slot* args) {
  return give(args, Host::of(vm).cell().is_moving(robot_id(args[0])));
}
Signal home(Vm& vm, Slot* args) {
  const CellRobot& robot = state_of(vm, args[0]);
  return give(args, new_posj(vm, make_posj(*robot.model, robot.model->home())));
}
Signal force(Vm& vm, Slot* args) {
  const auto wrench = Host::of(vm).cell().contact_wrench(robot_id(args[0]));
  RecordObj* record = new_record(vm, vm.program().library_record("Wrench"));
  if (record == nullptr) return Signal::kFail;
  for (int i = 0; i < 6; ++i) record->fields()[i].d = wrench[i];
  return give(args, record);
}

Signal dof(Vm& vm, Slot* args) {
  return give(args, static_cast<std::int64_t>(state_of(vm, args[0]).model->n()));
}
Signal name(Vm& vm, Slot* args) { return give(args, new_text(vm, state_of(vm, args[0]).name)); }
Signal types(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  std::string word;
  for (int i = 0; i < robot.n(); ++i) word += robot.is_revolute(i) ? 'R' : 'P';
  return give(args, new_text(vm, word));
}

Signal limits(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  return give_objects<PosJ>(
      vm, args, {make_posj(robot, robot.lower()), make_posj(robot, robot.upper())}, new_posj);
}

// ---- changing a robot
// ------------------------------------------------------------------------------------------

Signal set_model(Vm& vm, Slot robot, Robot model) try {
  if (refuse_busy(vm, robot_id(robot))) return Signal::kFail;
  Host::of(vm).cell().set_model(robot_id(robot), std::make_shared<const Robot>(std::move(model)));
  return give_nothing();
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error);
}
Signal set_tool(Vm& vm, Slot* args) {
  return set_model(vm, args[0], state_of(vm, args[0]).model->with_tool_point(posc(args[1]).T));
}
Signal set_home(Vm& vm, Slot* args) try {
  return set_model(vm, args[0], state_of(vm, args[0]).model->with_home(posj(args[1]).vector()));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error, 1);
}

// ---- kinematics
// ------------------------------------------------------------------------------------------------

template <bool kList>
Signal fkine(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  if (is_absent(args[2])) return give(args, new_posc(vm, {forward(robot, *q), true}));
  const std::int64_t k = args[2].i;
  if (k < 1 || k > robot.n())
    return failure(vm, "R0606", fmt::format("joint {} is outside 1 to {}", k, robot.n()), 2);
  return give(args, new_posc(vm, {link_frame(robot, *q, static_cast<int>(k)), true}));
}

Obj* make_frame(Vm& vm, const Eigen::Isometry3d& T) { return new_posc(vm, {T, true}); }
template <bool kList>
Signal link_frames(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  return give_objects<Eigen::Isometry3d>(vm, args, armlet::link_frames(robot, *q), make_frame);
}

template <bool kList>
Signal manipulability_of(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  return give(args, manipulability(robot, *q));
}

Signal give_matrix(Vm& vm, Slot* args, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  MatrixObj* matrix = new_matrix(vm, static_cast<std::uint32_t>(values.rows()),
                                 static_cast<std::uint32_t>(values.cols()));
  if (matrix == nullptr) return Signal::kFail;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    matrix->data()[i] = values(i / values.cols(), i % values.cols());
  return give(args, matrix);
}

// (r, q, frame)
template <bool kList>
Signal jacobian_of(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  const std::string_view name = text_value(args[2]);
  const auto frame = name == "world"  ? std::optional(JacobianFrame::kWorld)
                     : name == "base" ? std::optional(JacobianFrame::kBase)
                     : name == "tool" ? std::optional(JacobianFrame::kTool)
                                      : std::nullopt;
  if (!frame) {
    return failure(vm, "R0626", fmt::format("a Jacobian has no frame \"{}\"", name), 2,
                   "its frames are \"world\", \"base\" and \"tool\"");
  }
  return give_matrix(vm, args, armlet::jacobian(robot, *q, *frame));
}

// (r, q, qd)
template <bool kList, bool kRates>
Signal jacobian_dot(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  const auto qd = joint_argument(vm, robot, args[2], kRates, 2);
  if (!qd) return Signal::kFail;
  const Vector6d rate = jacobian_dot_qd(robot, *q, *qd);
  return give(args, new_reals(vm, {rate.data(), 6}));
}

// (r, q, qd)
template <bool kList>
Signal jacobian_rate_of(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  const auto q = joint_argument(vm, robot, args[1], kList, 1);
  if (!q) return Signal::kFail;
  const auto qd = joint_argument(vm, robot, args[2], true, 2);
  return qd ? give_matrix(vm, args, armlet::jacobian_rate(robot, *q, *qd)) : Signal::kFail;
}

Signal dh_table(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  Eigen::MatrixXd table(robot.n(), 4);
  for (int i = 0; i < robot.n(); ++i) {
    const DhRow& row = robot.joint(i).dh;
    table.row(i) << row.theta, row.d, row.a, row.alpha;
  }
  return give_matrix(vm, args, table);
}

Signal random_joints(Vm& vm, Slot* args) {
  const Robot& robot = *state_of(vm, args[0]).model;
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] = vm.random().uniform(robot.lower()[i], robot.upper()[i]);
  return give(args, new_posj(vm, make_posj(robot, q)));
}

constexpr std::string_view kJacobianDot =
    "The acceleration of the tool point that the joint speeds qd cause while they do not change: "
    "the rate of the Jacobian times qd, three values in m/s^2 and three in rad/s^2, in the world.";

constexpr NativeFunction kRobotFunctions[] = {
    {"joints", "(r: robot) -> posJ", "The joint values now.", "joints()", joints},
    {"jointSpeeds", "(r: robot) -> double[]", "The joint speeds now, rad/s and m/s.",
     "jointSpeeds()", joint_speeds},
    {"jointAccels", "(r: robot) -> double[]", "The joint accelerations now, rad/s^2 and m/s^2.",
     "jointAccels()", joint_accels},
    {"here", "(r: robot) -> posC", "The tool point now, in the world.", "here()", here},
    {"tcpSpeed", "(r: robot) -> double[]",
     "The velocity of the tool point: vx, vy, vz in m/s and wx, wy, wz in rad/s.", "tcpSpeed()",
     tcp_speed},
    {"force", "(r: robot) -> Wrench",
     "What the surroundings exert on the tool point; what the hand holds does not count.",
     "force().z", force},
    {"moving", "(r: robot) -> bool", "Whether the robot is on its way.", "moving()", moving},
    {"home", "(r: robot) -> posJ", "The home position.", "moveJ(home(), time: 2s)", home},
    {"robot.dof", "(r: robot) -> int", "The number of joints.", "robots.scara().dof", dof},
    {"robot.name", "(r: robot) -> string", "The name.", "robots.scara().name", name},
    {"robot.types", "(r: robot) -> string", "One letter per joint: R turns, P slides.",
     "robots.scara().types", types},
    {"limits", "(r: robot) -> posJ[]", "The lower and the upper joint limits.", "limits()", limits},
    commanding({"setTool", "(r: robot, tcp: posC)",
                "Moves the tool point, seen from the flange; the hand stays.",
                "setTool(xyz(z: 50mm))", set_tool}),
    {"setHome", "(r: robot, q: posJ)", "Changes the home position.", "setHome(joints())", set_home},
    {"fkine", "(r: robot, q: posJ, joint: int?) -> posC",
     "Where the tool point is for these joint values; with joint: the frame after that joint, "
     "counted from 1.",
     "fkine(joints())", fkine<false>},
    {"fkine", "(r: robot, q: double[], joint: int?) -> posC",
     "Where the tool point is for these joint values (SI).", "fkine([0.0, 0.0, 0.1, 0.0])",
     fkine<true>, nullptr, nullptr, check_joint_list<1>},
    {"linkFrames", "(r: robot, q: posJ) -> posC[]", "The frames after each joint.",
     "linkFrames(joints())", link_frames<false>},
    {"linkFrames", "(r: robot, q: double[]) -> posC[]", "The frames after each joint.",
     "linkFrames([0.0, 0.0, 0.1, 0.0])", link_frames<true>, nullptr, nullptr, check_joint_list<1>},
    {"manipulability", "(r: robot, q: posJ) -> double",
     "Yoshikawa's measure: zero where the arm is singular.", "manipulability(joints())",
     manipulability_of<false>},
    {"manipulability", "(r: robot, q: double[]) -> double",
     "Yoshikawa's measure: zero where the arm is singular.", "manipulability([0.0, 0.5, 0.1, 0.0])",
     manipulability_of<true>, nullptr, nullptr, check_joint_list<1>},
    {"jacobian", "(r: robot, q: posJ, frame: string = \"world\") -> matrix",
     "Maps joint speeds to the velocity of the tool point: three rows in m/s, three in rad/s, "
     "along "
     "the axes of the frame \"world\", \"base\" or \"tool\".",
     "jacobian(joints())", jacobian_of<false>},
    {"jacobian", "(r: robot, q: double[], frame: string = \"world\") -> matrix",
     "Maps joint speeds to the velocity of the tool point: three rows in m/s, three in rad/s, "
     "along "
     "the axes of the frame \"world\", \"base\" or \"tool\".",
     "jacobian([0.0, 0.5, 0.1, 0.0], frame: \"tool\")", jacobian_of<true>, nullptr, nullptr,
     check_joint_list<1>},
    {"jacobianDot", "(r: robot, q: posJ, qd: double[]) -> double[]", kJacobianDot,
     "jacobianDot(joints(), jointSpeeds())", jacobian_dot<false, true>},
    {"jacobianDot", "(r: robot, q: posJ, qd: posJ) -> double[]", kJacobianDot,
     "jacobianDot(joints(), joints())", jacobian_dot<false, false>},
    {"jacobianDot", "(r: robot, q: double[], qd: double[]) -> double[]", kJacobianDot,
     "jacobianDot([0.0, 0.5, 0.1, 0.0], [0.1, 0.2, 0.0, 0.3])", jacobian_dot<true, true>, nullptr,
     nullptr, check_joint_list<1>},
    {"jacobianRate", "(r: robot, q: posJ, qd: double[]) -> matrix",
     "The rate of change of the Jacobian while the joints move with qd, in the world's axes.",
     "jacobianRate(joints(), jointSpeeds())", jacobian_rate_of<false>},
    {"jacobianRate", "(r: robot, q: double[], qd: double[]) -> matrix",
     "The rate of change of the Jacobian while the joints move with qd, in the world's axes.",
     "jacobianRate([0.0, 0.5, 0.1, 0.0], [0.1, 0.2, 0.0, 0.3])", jacobian_rate_of<true>, nullptr,
     nullptr, check_joint_list<1>},
    {"dhTable", "(r: robot) -> matrix",
     "The Denavit-Hartenberg parameters, one row theta, d, a, alpha for each joint, in rad and m.",
     "dhTable()", dh_table},
    {"randomJoints", "(r: robot) -> posJ",
     "Joint values drawn evenly within the limits; the same ones in every run.", "randomJoints()",
     random_joints},
};

}  // namespace

std::span<const NativeFunction> robot_functions() { return kRobotFunctions; }

}  // namespace armlet::bind
