// Forces and accelerations of robots.

#include <fmt/format.h>

#include "armlet/dynamics/coriolis.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/stdlib/host.hpp"
#include "dynamics/loaded_arm.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/robots/give.hpp"
#include "values/robots/models.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// ---- forces and accelerations

template <class Q>
Answer<JointVector> inverse(Vm& vm, const RobotRef& r, Q values, JointList rates, JointList accels,
                            std::optional<JointList> load) {
  const Robot& robot = loaded_of(vm, r);
  const auto motion =
      joint_arguments(vm, robot, {at("q"), at("qd"), at("qdd")}, values, rates, accels);
  if (!motion) return Failed{};
  Vector6d wrench = Vector6d::Zero();
  if (load) {
    if (load->size() != 6) {
      return failure(
          vm, "R0613",
          fmt::format("a load has 6 values, three forces and three moments, not {}", load->size()),
          at("load"));
    }
    wrench = rotate_twist(robot.T_world_base().linear(),
                          Vector6d(Eigen::Map<const Vector6d>(load->data())));
  }
  return dynamics_of<JointVector>(vm, [&] {
    const auto& [q, qd, qdd] = *motion;
    return load ? inverse_dynamics(robot, q, qd, qdd, wrench) : inverse_dynamics(robot, q, qd, qdd);
  });
}

template <class Q>
Answer<JointVector> forward(Vm& vm, const RobotRef& r, Q values, JointList rates, JointList tau) {
  const Robot& robot = loaded_of(vm, r);
  const auto given = joint_arguments(vm, robot, {at("q"), at("qd"), at("tau")}, values, rates, tau);
  if (!given) return Failed{};
  return dynamics_of<JointVector>(vm, [&] {
    const auto& [q, qd, forces] = *given;
    return forward_dynamics(robot, q, qd, forces);
  });
}

template <class Result, class Q, class Law>
Answer<Result> of_joints(Vm& vm, const RobotRef& r, Q values, CallPart part, const Law& law) {
  const Robot& robot = loaded_of(vm, r);
  const auto q = joint_argument(vm, robot, values, part);
  if (!q) return Failed{};
  return dynamics_of<Result>(vm, [&] { return law(robot, *q); });
}

template <class Q>
Answer<JointMatrix> mass_of(Vm& vm, const RobotRef& r, Q values) {
  return of_joints<JointMatrix>(vm, r, values, at("q"), mass_matrix);
}
template <class Q>
Answer<JointVector> gravity_of(Vm& vm, const RobotRef& r, Q values) {
  return of_joints<JointVector>(vm, r, values, at("q"), gravity_forces);
}
template <class Q>
Answer<JointVector> friction_of(Vm& vm, const RobotRef& r, Q rates) {
  return of_joints<JointVector>(vm, r, rates, at("qd"), friction_forces);
}
template <class Q>
Answer<double> potential_of(Vm& vm, const RobotRef& r, Q values) {
  return of_joints<double>(vm, r, values, at("q"), potential_energy);
}

template <class Result, class Q, class Law>
Answer<Result> of_motion(Vm& vm, const RobotRef& r, Q values, JointList rates, const Law& law) {
  const Robot& robot = loaded_of(vm, r);
  const auto given = joint_arguments(vm, robot, {at("q"), at("qd")}, values, rates);
  if (!given) return Failed{};
  return dynamics_of<Result>(vm, [&] { return law(robot, (*given)[0], (*given)[1]); });
}

template <class Q>
Answer<JointMatrix> coriolis_of(Vm& vm, const RobotRef& r, Q values, JointList rates) {
  return of_motion<JointMatrix>(vm, r, values, rates, coriolis_matrix);
}
template <class Q>
Answer<double> kinetic_of(Vm& vm, const RobotRef& r, Q values, JointList rates) {
  return of_motion<double>(vm, r, values, rates, kinetic_energy);
}

// ---- for the present motion of the arm

template <class Result, class Law>
Answer<Result> now(Vm& vm, const RobotRef& r, const Law& law) {
  const CellRobot& state = state_of(vm, r);
  return dynamics_of<Result>(vm, [&] { return law(*state.loaded, state); });
}

Answer<JointMatrix> mass_now(Vm& vm, const RobotRef& r) {
  return now<JointMatrix>(vm, r, [](const Robot& robot, const CellRobot& state) {
    return mass_matrix(robot, state.q);
  });
}
Answer<JointMatrix> coriolis_now(Vm& vm, const RobotRef& r) {
  return now<JointMatrix>(vm, r, [](const Robot& robot, const CellRobot& state) {
    return coriolis_matrix(robot, state.q, state.qd);
  });
}
Answer<JointVector> gravity_now(Vm& vm, const RobotRef& r) {
  return now<JointVector>(vm, r, [](const Robot& robot, const CellRobot& state) {
    return gravity_forces(robot, state.q);
  });
}

// ---- the payload of the arm

Answer<JointVector> torques(Vm& vm, const RobotRef& r) {
  const CellRobot& state = state_of(vm, r);
  if (state.forces.size() != 0) return JointVector(state.forces);
  const Cell& cell = Host::of(vm).cell();
  return dynamics_of<JointVector>(vm, [&]() -> Eigen::VectorXd {
    return inverse_dynamics(*state.loaded, state.q, state.qd, state.qdd) -
           cell.contact_forces(r.id);
  });
}

// Replaces the model of an arm, as exchange_model does, also if the arm moves under torques.
template <class Make>
Answer<void> exchange_masses(Vm& vm, const RobotRef& r, CallPart part, const Make& make) {
  if (state_of(vm, r).forces.size() == 0) return exchange_model(vm, r, part, make);
  try {
    Host::of(vm).cell().set_model(r.id, std::make_shared<const Robot>(make(model_of(vm, r))));
    return {};
  } catch (const ArgumentError& error) {
    return failure_of(vm, row("R0630"), error, part);
  }
}

Answer<void> set_payload(Vm& vm, const RobotRef& r, double mass, const PosC* com) {
  return exchange_masses(vm, r, at("m"), [&](const Robot& robot) {
    Payload payload;
    payload.mass = mass;
    if (com != nullptr) payload.com = com->T.translation();
    return robot.with_payload(payload);
  });
}

template <class InertiaGiven>
Answer<void> set_link(Vm& vm, const RobotRef& r, std::int64_t joint, std::optional<double> mass,
                      Numbers com, InertiaGiven inertia, Numbers friction) {
  const Robot& robot = model_of(vm, r);
  if (joint < 1 || joint > robot.rows())
    return failure(vm, "R0606", fmt::format("joint {} is outside 1 to {}", joint, robot.rows()),
                   at("joint"));
  const int i = static_cast<int>(joint) - 1;
  Link link = robot.link(i);
  if (mass) link.mass = *mass;
  const auto about_com = inertia_argument(vm, inertia, at("inertia"));
  if (!about_com || !read_com(vm, com, at("com"), link) ||
      !read_friction(vm, friction, at("friction"), link))
    return Failed{};
  if (*about_com) link.inertia = **about_com;
  return exchange_masses(vm, r, at("joint"),
                         [&](const Robot& now) { return now.with_link(i, link); });
}

constexpr std::string_view kInverse =
    "What the motors give for this motion, at the joints, in N m and N: inertia, Coriolis forces, "
    "gravity and friction, also of the payload and of what the hand holds. load: what the "
    "surroundings exert on the tool point, three forces in N "
    "and three moments in N m along the axes of the base.";
constexpr std::string_view kForward =
    "The accelerations that these joint forces cause, rad/s^2 and m/s^2.";
constexpr std::string_view kMass =
    "The inertia matrix, with the inertia of the motors behind their gears.";
constexpr std::string_view kCoriolis =
    "The matrix of Christoffel symbols: times qd it gives Coriolis and centrifugal forces.";
constexpr std::string_view kGravity = "The joint forces that hold the arm still, N m and N.";
constexpr std::string_view kFriction = "The joint forces that friction takes at these speeds.";
constexpr std::string_view kKinetic = "The energy of the motion, with that of the motors.";
constexpr std::string_view kPotential =
    "The energy in the field of gravity; that of a mass at the origin of the world is zero.";

constexpr std::string_view kSetLink =
    "Changes the link behind a joint, counted from 1; what is left out stays. inertia: about the "
    "centre of mass, kg m^2, as a 3 x 3 matrix or as three rows. friction: [B, Tc+, Tc-, Ts, vs], "
    "or the first one or three of them.";

constexpr NativeFunction kDynamicsFunctions[] = {
    def<inverse<Joints>, inverse<JointList>>(
        "invDyn(r: robot, q: posJ | double[], qd: double[], qdd: double[], load: double[]?) -> "
        "double[]",
        kInverse,
        "invDyn(joints(), jointSpeeds(), jointAccels()); invDyn([0.0, 0.5, 0.1, 0.0], "
        "jointSpeeds(), jointAccels())",
        {.check = check_all_of<check_joint_list<"q">, note_forces>}),
    def<forward<Joints>, forward<JointList>>(
        "fwdDyn(r: robot, q: posJ | double[], qd: double[], tau: double[]) -> double[]", kForward,
        "fwdDyn(joints(), zeros(4), zeros(4)); robots.puma560().fwdDyn(zeros(6), zeros(6), "
        "zeros(6))",
        {.check = check_all_of<check_joint_list<"q">, note_accels>}),
    def<mass_of<Joints>, mass_of<JointList>>(
        "massMatrix(r: robot, q: posJ | double[]) -> matrix", kMass,
        "massMatrix(joints()); massMatrix([0.0, 0.5, 0.1, 0.0])", {.check = check_joint_list<"q">}),
    def<coriolis_of<Joints>, coriolis_of<JointList>>(
        "coriolis(r: robot, q: posJ | double[], qd: double[]) -> matrix", kCoriolis,
        "coriolis(joints(), [1.0, 1.0, 0.1, 1.0]); coriolis([0.0, 0.5, 0.1, 0.0], [1.0, 1.0, 0.1, "
        "1.0])",
        {.check = check_joint_list<"q">}),
    def<gravity_of<Joints>, gravity_of<JointList>>(
        "gravity(r: robot, q: posJ | double[]) -> double[]", kGravity,
        "gravity(joints()); gravity([0.0, 0.5, 0.1, 0.0])",
        {.check = check_all_of<check_joint_list<"q">, note_forces>}),
    def<friction_of<Joints>, friction_of<JointList>>(
        "friction(r: robot, qd: posJ | double[]) -> double[]", kFriction,
        "friction(joints()); friction(jointSpeeds())", {.check = note_forces}),
    def<kinetic_of<Joints>, kinetic_of<JointList>>(
        "kineticEnergy(r: robot, q: posJ | double[], qd: double[]) -> energy", kKinetic,
        "kineticEnergy(joints(), jointSpeeds()); kineticEnergy([0.0, 0.5, 0.1, 0.0], "
        "jointSpeeds())",
        {.check = check_joint_list<"q">}),
    def<potential_of<Joints>, potential_of<JointList>>(
        "potentialEnergy(r: robot, q: posJ | double[]) -> energy", kPotential,
        "potentialEnergy(joints()); potentialEnergy([0.0, 0.5, 0.1, 0.0])",
        {.check = check_joint_list<"q">}),
    def<mass_now>("massMatrix(r: robot) -> matrix",
                  "The inertia matrix where the arm is now, with what its hand holds.",
                  "massMatrix()"),
    def<coriolis_now>("coriolis(r: robot) -> matrix",
                      "The matrix of Christoffel symbols where the arm is now, at its speeds.",
                      "coriolis()"),
    def<gravity_now>("gravity(r: robot) -> double[]",
                     "The joint forces that hold the arm still where it is now, N m and N.",
                     "gravity()", {.check = note_forces}),
    def<torques>("torques(r: robot) -> double[]",
                 "What the motors give now, N m and N: the motion with the payload and with the "
                 "object in the hand, against what the hand and the links press on.",
                 "torques()", {.check = note_forces}),
    def<set_payload>(
        "setPayload(r: robot, m: mass, at: posC?)",
        "A mass at a point seen from the flange, which the last link carries from now on instead "
        "of the one before; at: the flange, if it is left out.",
        "setPayload(2kg, at: xyz(z: 40mm))", {.commands = true}),
    def<set_link<NumberRows>, set_link<const MatrixObj&>>(
        "setLink(r: robot, joint: int, mass: mass?, com: length[]?, inertia: double[][]? | matrix, "
        "friction: double[]?)",
        kSetLink,
        "setLink(joint: 2, mass: 3kg); setLink(joint: 2, mass: 3kg, inertia: [0.01, 0, 0; 0, 0.01, "
        "0; 0, 0, 0.01])",
        {.check = check_inertia<"inertia">, .commands = true}),
};

}  // namespace

std::span<const NativeFunction> dynamics_functions() { return kDynamicsFunctions; }

}  // namespace armlet::bind
