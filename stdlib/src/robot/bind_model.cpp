// Robots: blocks of joints, tables, predefined arms, and what is mounted on them (language
// reference, sections 13.1 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/model/catalog.hpp"
#include "armlet/model/joint_limits.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "robot/bodies.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/matrices.hpp"
#include "values/robots/models.hpp"
#include "values/robots/own_pairs.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"
#include "values/world/meshes.hpp"

namespace armlet::bind {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using Number = std::optional<double>;
using Text = std::optional<std::string_view>;

// ---- rows: joint revolute(...), joint prismatic(...) --------------------------------------------

Answer<void> read_limits(Vm& vm, Numbers limits, Joint& joint) {
  if (!limits) return {};
  if (limits->size() != 2) {
    return failure(
        vm, "R0613",
        fmt::format("limits are two values, the lower and the upper one, not {}", limits->size()),
        at("limits"));
  }
  joint.lower = (*limits)[0];
  joint.upper = (*limits)[1];
  return {};
}

template <JointKind kKind, class InertiaGiven>
Answer<JointRow> joint_row(Vm& vm, double theta, double d, double a, double alpha, Numbers limits,
                           Number max_speed, Number max_accel, Number max_jerk, Number max_effort,
                           double mass, Numbers com, InertiaGiven inertia, Numbers friction,
                           double motor_inertia, double gear, Text mesh, Number mesh_unit,
                           double mesh_scale) {
  JointRow row{.joint = joint_without_limits(kKind), .link = {}};
  Joint& joint = row.joint;
  joint.dh = {theta, d, a, alpha};
  joint.max_speed = max_speed.value_or(0.0);
  joint.max_accel = max_accel.value_or(0.0);
  joint.max_jerk = max_jerk.value_or(0.0);
  if (max_effort) joint.max_effort = *max_effort;
  row.link.mass = mass;
  row.link.motor_inertia = motor_inertia;
  row.link.gear = gear;
  if (mesh) row.link.mesh = *mesh;
  const double factors[] = {mesh_unit.value_or(1.0), mesh_scale};
  for (int k = 0; k < 2; ++k) {
    if (std::isfinite(factors[k]) && factors[k] > 0.0) continue;
    return fail_mesh(vm, row.link.mesh,
                     fmt::format("its {} is {}{}; expected more than 0", k == 0 ? "unit" : "scale",
                                 factors[k], k == 0 ? " m" : ""),
                     {}, k == 0 ? at("meshUnit") : at("meshScale"));
  }
  if (mesh_unit) row.link.mesh_unit = *mesh_unit;
  row.link.mesh_scale = mesh_scale;
  const auto about_com = inertia_argument(vm, inertia, at("inertia"));
  if (!about_com || !read_limits(vm, limits, joint) || !read_com(vm, com, at("com"), row.link) ||
      !read_friction(vm, friction, at("friction"), row.link)) {
    return Failed{};
  }
  if (*about_com) row.link.inertia = **about_com;
  return row;
}

// ---- robots -------------------------------------------------------------------------------------

InertiaCheck inertia_check_of(std::string_view word) {
  const auto* known = std::ranges::find(kInertiaWords, word);
  if (known != kInertiaWords.end()) return static_cast<InertiaCheck>(known - kInertiaWords.begin());
  throw ArgumentError(
      fmt::format("Inertias are \"rigid\" (of bodies that can exist) or \"published\" (kept as "
                  "they are), not \"{}\".",
                  word));
}

// Fails for meshes that are no files below the folder of the program.
void check_meshes(Vm& vm, const RobotSpec& spec) {
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    const std::string& mesh = spec.links[i].mesh;
    if (mesh.empty() || Host::of(vm).has_mesh({}, mesh)) continue;
    throw ArgumentError(fmt::format("The mesh \"{}\" of link {} of robot `{}` is not there.", mesh,
                                    i + 1, spec.name));
  }
}

// Reads the meshes of joint rows into their links; R0656 for one that cannot be used.
Answer<void> load_meshes(Vm& vm, RobotSpec& spec) {
  for (Link& link : spec.links) {
    if (link.mesh.empty()) continue;
    const auto mesh =
        load_link_mesh(vm, {}, link.mesh, {.unit = link.mesh_unit, .scale = link.mesh_scale});
    if (!mesh.ok()) return fail_mesh(vm, link.mesh, mesh.error().message, {}, {});
    if (*mesh != nullptr) link.bodies.push_back({.triangles = *mesh});
  }
  return {};
}

// robot name { joint ...; base: ...; tool: ...; gravity: ...; convention: ... }
Answer<RobotRef> robot_block(Vm& vm, std::string_view name, HostList<JointRow> joints,
                             const PosC* base, const ToolValue* tool, Numbers gravity,
                             std::string_view convention, const PosJ* home, const PosC* tcp,
                             std::string_view inertias, NamePairs allow, NamePairs watch,
                             HostList<BodyRow> bodies) try {
  RobotSpec spec;
  spec.name = name;
  spec.source = "declared in the program";
  spec.convention = convention_of(convention);
  bool has_forces = false;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointRow& row = joints[i];
    spec.joints.push_back(row.joint);
    spec.links.push_back(row.link);
    const Friction& friction = row.link.friction;
    has_forces = has_forces || friction.viscous != 0.0 || friction.coulomb_plus != 0.0 ||
                 friction.coulomb_minus != 0.0 || friction.static_torque != 0.0 ||
                 row.link.mass != 0.0 || row.link.motor_inertia != 0.0 ||
                 !row.link.inertia.isZero(0.0) || !row.link.mesh.empty();
  }
  spec.inertia_check = inertia_check_of(inertias);
  check_meshes(vm, spec);
  if (!load_meshes(vm, spec)) return Failed{};
  const auto has_bodies = add_bodies(vm, bodies, spec);
  if (!has_bodies) return Failed{};
  if (!has_forces && !*has_bodies) spec.links.clear();
  if (!read_vector3(vm, gravity, at("gravity"), "gravity", spec.gravity)) return Failed{};
  if (home != nullptr) spec.home = home->vector();
  Robot robot = finished(Robot(std::move(spec)), base, tool);
  if (tcp != nullptr) robot = robot.with_tool_point(tcp->T);
  return add_robot(vm, with_own_pairs(std::move(robot), allow, watch));
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0630"), error);
}

// W0747: assumptions where a description is incomplete.
void advise_notes(Vm& vm, const std::string& path, const RobotSpec& spec) {
  for (const std::string& note : spec.notes) {
    Failure advice;
    advice.headline = {row("W0747"), {path, note}};
    advice.mark = CallPart::callee();
    vm.advise(advice);
  }
}

// A robot from a file in the folder of the program.
Answer<RobotRef> robot_from_urdf(Vm& vm, std::string_view file, Text tip, std::string_view inertias,
                                 const PosC* base, const ToolValue* tool, Text name,
                                 NamePairs allow, NamePairs watch) try {
  const std::string path(file);
  const Result<std::string> text = Host::of(vm).load_file(path);
  if (!text.ok()) {
    return failure(vm, "R0626",
                   fmt::format("\"{}\" cannot be read: {}", path, text.error().message),
                   at("path"));
  }
  UrdfOptions options;
  options.inertia_check = inertia_check_of(inertias);
  options.has_mesh = [&](const std::string& mesh) { return Host::of(vm).has_mesh(path, mesh); };
  options.load_glb = [&](const std::string& mesh) { return load_link_glb(vm, path, mesh); };
  Result<RobotSpec> spec = serial_arm_of_urdf(*text, options, tip.value_or(""));
  if (!spec.ok())
    return failure_of(vm, row("R0630"), ArgumentError(spec.error().message), at("path"));
  advise_notes(vm, path, *spec);
  Robot robot = finished(Robot(std::move(spec).value()), base, tool, name);
  return add_robot(vm, with_own_pairs(std::move(robot), allow, watch));
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0630"), error);
}

Answer<RobotRef> default_robot(Vm& vm) {
  const Result<int> id = Host::of(vm).default_robot();
  const auto model = Host::of(vm).default_robot_model();
  if (!id.ok() && model != nullptr && Host::of(vm).cell().find_robot(model->name())) {
    return failure(
        vm, row("R0630"), fmt::format("there is already a robot \"{}\" in the cell", model->name()),
        {},
        "a robot that was made without a name of the program has the name of its model, and a "
        "command without a robot is for the one that every program begins with",
        fmt::format("give it a name, robot arm = robots.{}(), and command it: arm.moveJ(home())",
                    model->name()));
  }
  if (!id.ok()) return failure_of(vm, row("R0630"), ArgumentError(id.error().message));
  return RobotRef{*id, &Host::of(vm).cell()};
}

// ---- tools --------------------------------------------------------------------------------------

Answer<ToolValue> gripper(Vm& vm, double stroke, double length, double force,
                          Number max_force) try {
  Tool tool = parallel_gripper(stroke, length, force);
  if (max_force && !(*max_force > 0.0 && std::isfinite(*max_force)))
    return domain_failure(vm, "maxForce", *max_force, "be above 0 N", {}, at("maxForce"));
  if (max_force) tool.max_force = *max_force;
  return ToolValue{tool, {}};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}
Answer<ToolValue> suction(Vm& vm, double radius, double length) try {
  return ToolValue{suction_cup(radius, length), {}};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}
ToolValue tool_point(const PosC& p) { return {point_tool(), p.T}; }

// A row of either kind, for one type of the inertia argument.
#define ARMLET_JOINT_ROW(KIND, ANGLE_OR_LENGTH, RATE, EFFORT, INERTIA)                     \
  "robot.joint." KIND                                                                      \
  "(theta: angle = 0rad, d: length = 0m, a: length = 0m, alpha: angle = 0rad, "            \
  "limits: " ANGLE_OR_LENGTH "[]?, " RATE ", " EFFORT                                      \
  "?, mass: mass = 0kg, com: length[]?, inertia: " INERTIA                                 \
  ", friction: double[]?, motorInertia: double = 0.0, gear: double = 1.0, mesh: string?, " \
  "meshUnit: length?, meshScale: double = 1.0) -> jointRow"
#define ARMLET_REVOLUTE_ROW(INERTIA)                                                   \
  ARMLET_JOINT_ROW(                                                                    \
      "revolute", "angle",                                                             \
      "maxSpeed: angularSpeed?, maxAccel: angularAccel?, maxJerk: angularAccel/time?", \
      "maxTorque: torque", INERTIA)
#define ARMLET_PRISMATIC_ROW(INERTIA)                                                             \
  ARMLET_JOINT_ROW("prismatic", "length",                                                         \
                   "maxSpeed: speed?, maxAccel: accel?, maxJerk: accel/time?", "maxForce: force", \
                   INERTIA)

constexpr std::string_view kRevolute =
    "A joint that turns, with its Denavit-Hartenberg row; theta is its zero. inertia: of the link "
    "about its centre of mass, kg m^2, as a 3 x 3 matrix or as three rows.";
constexpr std::string_view kPrismatic =
    "A joint that slides, with its Denavit-Hartenberg row; d is its zero. inertia: of the link "
    "about its centre of mass, kg m^2, as a 3 x 3 matrix or as three rows.";

constexpr NativeFunction kModelFunctions[] = {
    def<joint_row<JointKind::kRevolute, NumberRows>>(
        ARMLET_REVOLUTE_ROW("double[][]?"), kRevolute,
        "joint revolute(d: 400mm, a: 250mm, limits: [-170deg, 170deg])",
        {.check = check_revolute_row}),
    def<joint_row<JointKind::kRevolute, const MatrixObj&>>(
        ARMLET_REVOLUTE_ROW("matrix"), kRevolute,
        "joint revolute(a: 250mm, mass: 2kg, inertia: [0.01, 0, 0; 0, 0.02, 0; 0, 0, 0.02])",
        {.check = check_revolute_row}),
    def<joint_row<JointKind::kPrismatic, NumberRows>>(
        ARMLET_PRISMATIC_ROW("double[][]?"), kPrismatic, "joint prismatic(limits: [0mm, 150mm])",
        {.check = check_prismatic_row}),
    def<joint_row<JointKind::kPrismatic, const MatrixObj&>>(
        ARMLET_PRISMATIC_ROW("matrix"), kPrismatic,
        "joint prismatic(mass: 1kg, inertia: [0.01, 0, 0; 0, 0.01, 0; 0, 0, 0.002])",
        {.check = check_prismatic_row}),
    def<robot_block>(
        "robot{}(name: string, joint: jointRow[], base: posC?, tool: tool?, gravity: accel[]?, "
        "convention: string = \"standard\", home: posJ?, tcp: posC?, inertias: string = \"rigid\", "
        "allow: string[][]?, watch: string[][]?, body: bodyRow[]) -> robot",
        "A robot made of joints; tcp: the tool point seen from the flange, if the hand does not "
        "say it; inertias: \"published\" keeps numbers that no rigid body has; allow, watch: pairs "
        "of links that are never, or always, compared with each other, [[\"base\", \"link 3\"]].",
        "robot arm { joint revolute(a: 300mm) }",
        {.check = check_all_of<check_word<"convention", kConventions>,
                               check_word<"inertias", kInertiaWords>, check_robot_block>}),
    def<robot_from_urdf>(
        "urdf(path: string, tip: string?, inertias: string = \"rigid\", base: posC?, tool: tool?, "
        "name: string?, allow: string[][]?, watch: string[][]?) -> robot",
        "A robot from a description in the program's folder; tip: the link at its end, where the "
        "file has several arms; allow, watch: pairs of links, by name, that are never, or always, "
        "compared with each other.",
        "urdf(\"arm.urdf\", tip: \"tool0\")",
        {.check = check_all_of<check_word<"inertias", kInertiaWords>, note_read_robot>}),
    def<default_robot>("robot()() -> robot", "The robot that the host supplies.", "joints()",
                       {.check = check_default_robot}),
};

constexpr NativeFunction kToolFunctions[] = {
    def<gripper>(
        "parallelGripper(stroke: length, length: length = 120mm, force: force = 20N, maxForce: "
        "force?) -> tool",
        "A gripper with two fingers; the tool point is `length` along the flange's z axis. "
        "maxForce: what it can stand when it is pressed on something.",
        "parallelGripper(stroke: 60mm)", {.check = note_upright}),
    def<suction>("suctionCup(radius: length, length: length = 60mm) -> tool", "A suction cup.",
                 "suctionCup(radius: 15mm)", {.check = note_upright}),
    def<tool_point>("tcp(p: posC) -> tool", "A tool point without a hand; it cannot grasp.",
                    "tcp(xyz(z: 50mm))"),
};

// A function robots.NAME for every arm of the catalogue.
std::vector<Definition> ready_robots() {
  std::vector<Definition> robots;
  for (const CatalogArm& entry : catalog_arms()) {
    const std::string name = fmt::format("robots.{}", entry.name);
    const auto make = [arm = entry.name](Vm& vm, const PosC* base, const ToolValue* tool,
                                         Text own_name) -> Answer<RobotRef> {
      try {
        return add_robot(vm, finished(*make_robot(arm), base, tool, own_name));
      } catch (const ArgumentError& error) {
        return failure_of(vm, row("R0630"), error);
      }
    };
    robots.push_back(def(name + "(base: posC?, tool: tool?, name: string?) -> robot", make,
                         std::string(entry.help), name + "()", {.check = check_ready_robot}));
  }
  return robots;
}

}  // namespace

std::span<const NativeFunction> model_functions() {
  static const std::vector<Definition> robots = ready_robots();
  static const std::vector<NativeFunction> functions = [] {
    std::vector<NativeFunction> all(std::begin(kModelFunctions), std::end(kModelFunctions));
    for (const Definition& robot : robots) all.push_back(robot.function);
    all.insert(all.end(), std::begin(kToolFunctions), std::end(kToolFunctions));
    return all;
  }();
  return functions;
}

}  // namespace armlet::bind
