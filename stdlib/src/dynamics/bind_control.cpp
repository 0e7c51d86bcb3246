// Control laws, for simulate and torqueJ (language reference, section 13.5).

#include <fmt/format.h>

#include "armlet/dynamics/control.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/host.hpp"
#include "dynamics/loaded_arm.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/robots/give.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Eigen::VectorXd;
using Values = std::optional<JointList>;

// Values for the joints; 0 for each argument that was left out.
Answer<VectorXd> joints_or_zero(Vm& vm, const Robot& robot, Values values, CallPart part) {
  if (!values) return VectorXd(VectorXd::Zero(robot.n()));
  return joint_argument(vm, robot, *values, part);
}

// Values for the six directions of the tool; 0 if they were left out.
Answer<Vector6d> six_values(Vm& vm, Values values, std::string_view what, CallPart part) {
  if (!values) return Vector6d(Vector6d::Zero());
  if (values->size() == 6) return Vector6d(Eigen::Map<const Vector6d>(values->data()));
  return failure(
      vm, "R0613",
      fmt::format("{} has 6 values, along x, y, z and about them, not {}", what, values->size()),
      part);
}

// Checks gains: none may be below zero.
template <class Gains>
Answer<Gains> checked_gains(Vm& vm, Answer<Gains> gains, std::string_view what, CallPart part) {
  if (!gains) return Failed{};
  for (Eigen::Index i = 0; i < gains->size(); ++i) {
    if ((*gains)[i] >= 0.0) continue;
    return domain_failure(vm, fmt::format("{} {}", what, i + 1), (*gains)[i], "not be negative", {},
                          part);
  }
  return gains;
}

// ---- joint by joint

// The arguments of a control law in joint space: parameters q, qd, to, kp, kd and rates.
struct JointTask {
  VectorXd q, qd, to, kp, kd, rates;

  [[nodiscard]] VectorXd pull() const {
    return kp.cwiseProduct(to - q) + kd.cwiseProduct(rates - qd);
  }
};

template <class To>
Answer<JointTask> joint_task(Vm& vm, const Robot& robot, JointList q, JointList qd, To to,
                             JointList kp, JointList kd, Values rates) {
  const auto now = joint_argument(vm, robot, q, at("q"));
  if (!now) return Failed{};
  const auto speed = joint_argument(vm, robot, qd, at("qd"));
  if (!speed) return Failed{};
  const auto goal = joint_argument(vm, robot, to, at("to"));
  if (!goal) return Failed{};
  const auto stiff = checked_gains(vm, joint_argument(vm, robot, kp, at("kp")), "gain", at("kp"));
  if (!stiff) return Failed{};
  const auto damp = checked_gains(vm, joint_argument(vm, robot, kd, at("kd")), "gain", at("kd"));
  if (!damp) return Failed{};
  const auto wanted = joints_or_zero(vm, robot, rates, at("rates"));
  if (!wanted) return Failed{};
  return JointTask{*now, *speed, *goal, *stiff, *damp, *wanted};
}

template <class To>
Answer<JointVector> pd(Vm& vm, const RobotRef& r, JointList q, JointList qd, To to, JointList kp,
                       JointList kd, Values rates, bool gravity) {
  const Robot& robot = loaded_of(vm, r);
  const auto task = joint_task<To>(vm, robot, q, qd, to, kp, kd, rates);
  if (!task) return Failed{};
  return dynamics_of<JointVector>(vm, [&]() -> JointVector {
    JointVector tau = task->pull();
    if (gravity) tau += gravity_forces(robot, task->q);
    return tau;
  });
}

template <class To>
Answer<JointVector> computed_torques(Vm& vm, const RobotRef& r, JointList q, JointList qd, To to,
                                     JointList kp, JointList kd, Values rates, Values accels) {
  const Robot& robot = loaded_of(vm, r);
  const auto task = joint_task<To>(vm, robot, q, qd, to, kp, kd, rates);
  if (!task) return Failed{};
  const auto wanted = joints_or_zero(vm, robot, accels, at("accels"));
  if (!wanted) return Failed{};
  return dynamics_of<JointVector>(
      vm, [&] { return inverse_dynamics(robot, task->q, task->qd, *wanted + task->pull()); });
}

// ---- of the tool

// The pose of the tool and its error relative to the goal, along the axes of the world.
struct ToolTask {
  VectorXd q, qd;
  Jacobian J;
  Vector6d error, rate_error;
  bool turns;  // the goal has an orientation
};

// Reads the parameters q, qd, to and speed.
Answer<ToolTask> tool_task(Vm& vm, const Robot& robot, JointList q, JointList qd, const PosC& to,
                           Values speed) {
  const auto now = joint_argument(vm, robot, q, at("q"));
  if (!now) return Failed{};
  const auto rates = joint_argument(vm, robot, qd, at("qd"));
  if (!rates) return Failed{};
  const auto wanted = six_values(vm, speed, "a speed of the tool", at("speed"));
  if (!wanted) return Failed{};
  ToolTask task{.q = *now, .qd = *rates, .turns = to.has_orientation};
  const Eigen::Isometry3d T = forward_and_jacobian(robot, task.q, task.J);
  task.error << to.T.translation() - T.translation(),
      rotation_log(to.T.linear() * T.linear().transpose());
  task.rate_error = *wanted - task.J * task.qd;
  if (!task.turns) task.error.tail<3>().setZero();
  return task;
}

Answer<JointVector> operational(Vm& vm, const RobotRef& r, JointList q, JointList qd,
                                const PosC& to, JointList kp, JointList kd, Values speed,
                                Values accel, double settle) try {
  const Robot& robot = loaded_of(vm, r);
  const auto task = tool_task(vm, robot, q, qd, to, speed);
  if (!task) return Failed{};
  const auto stiff = checked_gains(vm, six_values(vm, kp, "kp", at("kp")), "gain", at("kp"));
  if (!stiff) return Failed{};
  const auto damp = checked_gains(vm, six_values(vm, kd, "kd", at("kd")), "gain", at("kd"));
  if (!damp) return Failed{};
  const auto wanted = six_values(vm, accel, "an acceleration of the tool", at("accel"));
  if (!wanted) return Failed{};
  if (!(settle >= 0.0))
    return domain_failure(vm, "settle", settle, "not be negative", {}, at("settle"));
  const Vector6d a = *wanted + damp->cwiseProduct(task->rate_error) +
                     stiff->cwiseProduct(task->error) - jacobian_dot_qd(robot, task->q, task->qd);
  // Directions without gains are not controlled.
  std::vector<int> rows;
  for (int i = 0; i < 6; ++i) {
    const bool is_known = i < 3 || task->turns;
    if (is_known && ((*stiff)[i] > 0.0 || (*damp)[i] > 0.0)) rows.push_back(i);
  }
  if (rows.empty()) {
    return failure(vm, "R0613", "all gains are 0, so the tool is free in every direction", at("kp"),
                   {}, "give kp and kd of the directions that matter");
  }
  const JointVector without_accel =
      bias_forces(robot, task->q, task->qd) + friction_forces(robot, task->qd);
  const auto tau = operational_forces(mass_matrix(robot, task->q), task->J(rows, Eigen::all),
                                      a(rows), without_accel, task->qd, settle);
  if (tau.ok()) return tau.value();
  Failure f;
  f.headline = {row("R0640"), {tau.error().message}};
  f.resource = robot_called(robot.name());
  f.fix = "leave the gains of a direction at 0, or keep away from singular positions";
  return fail(vm, std::move(f));
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0640"), error);
}

Answer<JointVector> impedance(Vm& vm, const RobotRef& r, JointList q, JointList qd, const PosC& to,
                              JointList stiffness, JointList damping, Values speed) {
  const Robot& robot = loaded_of(vm, r);
  const auto task = tool_task(vm, robot, q, qd, to, speed);
  if (!task) return Failed{};
  const auto stiff = checked_gains(vm, six_values(vm, stiffness, "a stiffness", at("stiffness")),
                                   "stiffness", at("stiffness"));
  if (!stiff) return Failed{};
  const auto damp = checked_gains(vm, six_values(vm, damping, "a damping", at("damping")),
                                  "damping", at("damping"));
  if (!damp) return Failed{};
  const Vector6d wrench = stiff->cwiseProduct(task->error) + damp->cwiseProduct(task->rate_error);
  return dynamics_of<JointVector>(vm, [&]() -> JointVector {
    return bias_forces(robot, task->q, task->qd) + task->J.transpose() * wrench;
  });
}

// ---- compliance

enum ComplianceField { kOffset, kRate };

Answer<RecordObj*> compliance_record(Vm& vm, const Compliance& state) {
  RecordObj* record = new_record(vm, vm.program().library_record("Compliance"));
  if (record == nullptr) return Failed{};
  Slot* fields = record->fields();
  if (Given<VectorXd>::leave(vm, state.offset, fields[kOffset]) == Signal::kDone &&
      Given<VectorXd>::leave(vm, state.rate, fields[kRate]) == Signal::kDone)
    return record;
  release(vm, record);
  return Failed{};
}

Answer<RecordObj*> compliance(Vm& vm) { return compliance_record(vm, {}); }

Answer<RecordObj*> given_way(Vm& vm, const RecordObj& state, JointList wrench, JointList mass,
                             JointList damping, JointList stiffness, double during) try {
  const auto part = [&](ComplianceField field) {
    return six_values(vm, reals_value(state.fields()[field]), "a compliance", at("state"));
  };
  const auto offset = part(kOffset);
  if (!offset) return Failed{};
  const auto rate = part(kRate);
  if (!rate) return Failed{};
  const auto force = six_values(vm, wrench, "a wrench", at("wrench"));
  if (!force) return Failed{};
  const auto masses = six_values(vm, mass, "a mass", at("mass"));
  if (!masses) return Failed{};
  const auto dampings = six_values(vm, damping, "a damping", at("damping"));
  if (!dampings) return Failed{};
  const auto springs = six_values(vm, stiffness, "a stiffness", at("stiffness"));
  if (!springs) return Failed{};
  return compliance_record(
      vm, give_way({*offset, *rate}, *force, *masses, *dampings, *springs, during));
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0640"), error);
}

constexpr std::string_view kPd =
    "The torques kp (to - q) + kd (rates - qd), joint by joint, N m and N; with gravity also what "
    "holds the arm. rates: the speeds that the goal has, 0 if they are left out.";
constexpr std::string_view kComputed =
    "Computed torque: what invDyn gives for the acceleration accels + kp (to - q) + kd (rates - "
    "qd). Where the model is right the error e obeys e'' + kd e' + kp e = 0, joint by joint: "
    "critically damped with kp = w^2 and kd = 2 w.";

constexpr NativeFunction kControlFunctions[] = {
    def<pd<Joints>, pd<JointList>>(
        "pdTorques(r: robot, q: double[], qd: double[], to: posJ | double[], kp: double[], kd: "
        "double[], rates: double[]?, gravity: bool = false) -> double[]",
        kPd,
        "pdTorques(joints().q, zeros(4), to: joints(), kp: [9.0, 9.0, 9.0, 9.0], kd: "
        "[6.0, 6.0, 6.0, 6.0])"),
    def<computed_torques<Joints>, computed_torques<JointList>>(
        "computedTorques(r: robot, q: double[], qd: double[], to: posJ | double[], kp: double[], "
        "kd: double[], rates: double[]?, accels: double[]?) -> double[]",
        kComputed,
        "computedTorques(joints().q, zeros(4), to: joints(), kp: [9.0, 9.0, 9.0, 9.0], kd: [6.0, "
        "6.0, 6.0, 6.0])"),
    def<operational>(
        "operationalTorques(r: robot, q: double[], qd: double[], to: posC, kp: double[], kd: "
        "double[], speed: double[]?, accel: double[]?, settle: double = 0.0) -> double[]",
        "Torques that give the tool the acceleration accel + kp e + kd e', e its distance from the "
        "goal along x, y, z and about them, in the axes of the world; the friction of the joints "
        "is made up for. Directions with both gains 0 "
        "are left free; settle, 1/s, damps motions of the arm that these directions do not see.",
        "operationalTorques(joints().q, zeros(4), to: here(), kp: [9.0, 9.0, 9.0, 0.0, 0.0, 9.0], "
        "kd: [6.0, 6.0, 6.0, 0.0, 0.0, 6.0])"),
    def<impedance>(
        "impedanceTorques(r: robot, q: double[], qd: double[], to: posC, stiffness: double[], "
        "damping: double[], speed: double[]?) -> double[]",
        "Torques that make the tool a spring with a damper between it and the goal, N/m and N m, N "
        "s/m and N m s along the axes of the world and about them, and that carry the arm. A force "
        "f on the tool moves it by f / stiffness.",
        "impedanceTorques(joints().q, zeros(4), to: here(), stiffness: [500.0, 500.0, 500.0, 20.0, "
        "20.0, 20.0], damping: [40.0, 40.0, 40.0, 2.0, 2.0, 2.0])"),
    def<compliance>("compliance() -> Compliance",
                    "What yields to forces, at rest at its place: `offset` and `rate`, six values "
                    "each, along x, y, z and about them.",
                    "compliance().offset"),
    def<given_way>(
        "giveWay(state: Compliance, wrench: double[], mass: double[], damping: double[], "
        "stiffness: "
        "double[], during: time) -> Compliance",
        "The compliance after a time under a constant wrench, three forces and three moments: mass "
        "x'' + damping x' + stiffness x = wrench in each direction, solved exactly. It is the "
        "admittance of a controller that moves the goal of a stiff arm.",
        "giveWay(compliance(), [5.0, 0.0, 0.0, 0.0, 0.0, 0.0], mass: [1.0, 1.0, 1.0, 1.0, 1.0, "
        "1.0], "
        "damping: [20.0, 20.0, 20.0, 1.0, 1.0, 1.0], stiffness: [100.0, 100.0, 100.0, 9.0, 9.0, "
        "9.0], during: 10ms).offset[0]"),
};

}  // namespace

std::span<const NativeFunction> control_functions() { return kControlFunctions; }

}  // namespace armlet::bind
