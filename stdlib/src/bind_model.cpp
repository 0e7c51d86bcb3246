// Robots: blocks of joints, tables, ready arms, and what is mounted on them (language
// reference, sections 13.1 and 19).

#include <fmt/format.h>

#include <cmath>

#include "armlet/model/catalog.hpp"
#include "armlet/model/joint_limits.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "models.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

double or_zero(Slot s) { return is_absent(s) ? 0.0 : s.d; }

// ---- rows: joint revolute(...), joint prismatic(...)
// ----------------------------------------------------------- Parameters of both rows, in order.
enum Row {
  kTheta,
  kD,
  kA,
  kAlpha,
  kLimits,
  kMaxSpeed,
  kMaxAccel,
  kMaxJerk,
  kMaxEffort,
  kMass,
  kCom,
  kInertia,
  kFriction,
  kMotorInertia,
  kGear,
  kMesh
};

bool read_limits(Vm& vm, Slot slot, Joint& joint) {
  if (slot.o == nullptr) return true;
  const auto limits = reals_value(slot);
  if (limits.size() != 2) {
    static_cast<void>(failure(
        vm, "R0613",
        fmt::format("limits are two values, the lower and the upper one, not {}", limits.size()),
        kLimits));
    return false;
  }
  joint.lower = limits[0];
  joint.upper = limits[1];
  return true;
}

bool read_vector3(Vm& vm, Slot slot, int parameter, std::string_view what, Vector3d& out) {
  if (slot.o == nullptr) return true;
  const auto values = reals_value(slot);
  if (values.size() != 3) {
    static_cast<void>(failure(
        vm, "R0613", fmt::format("{} has 3 values, not {}", what, values.size()), parameter));
    return false;
  }
  out = Vector3d(values[0], values[1], values[2]);
  return true;
}

bool read_inertia(Vm& vm, Slot slot, Link& link) {
  if (slot.o == nullptr) return true;
  const auto rows = items_value(slot);
  bool square = rows.size() == 3;
  for (std::size_t i = 0; square && i < 3; ++i) square = reals_value(rows[i]).size() == 3;
  if (!square) {
    static_cast<void>(failure(vm, "R0613", "an inertia has 3 rows of 3 values", kInertia));
    return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) link.inertia(i, j) = reals_value(rows[i])[j];
  }
  return true;
}

bool read_friction(Vm& vm, Slot slot, Link& link) {
  if (slot.o == nullptr) return true;
  const auto f = reals_value(slot);
  if (f.size() != 1 && f.size() != 3) {
    static_cast<void>(failure(
        vm, "R0613", fmt::format("friction is [B] or [B, Tc+, Tc-], not {} values", f.size()),
        kFriction));
    return false;
  }
  link.friction.viscous = f[0];
  if (f.size() == 3) {
    link.friction.coulomb_plus = f[1];
    link.friction.coulomb_minus = f[2];
  }
  return true;
}

template <JointKind kKind>
Signal joint_row(Vm& vm, Slot* args) {
  JointRow row{.joint = joint_without_limits(kKind), .link = {}};
  Joint& joint = row.joint;
  joint.dh = {args[kTheta].d, args[kD].d, args[kA].d, args[kAlpha].d};
  joint.max_speed = or_zero(args[kMaxSpeed]);
  joint.max_accel = or_zero(args[kMaxAccel]);
  joint.max_jerk = or_zero(args[kMaxJerk]);
  if (!is_absent(args[kMaxEffort])) joint.max_effort = args[kMaxEffort].d;
  row.link.mass = args[kMass].d;
  row.link.motor_inertia = args[kMotorInertia].d;
  row.link.gear = args[kGear].d;
  if (args[kMesh].o != nullptr) row.link.mesh = std::string(text_value(args[kMesh]));
  if (!read_limits(vm, args[kLimits], joint) ||
      !read_vector3(vm, args[kCom], kCom, "the centre of mass", row.link.com) ||
      !read_inertia(vm, args[kInertia], row.link) ||
      !read_friction(vm, args[kFriction], row.link)) {
    return Signal::kFail;
  }
  return give(args, new_host_value(vm, kJointRow, row));
}

// ---- robots
// ----------------------------------------------------------------------------------------------------

}  // namespace

Signal add_robot(Vm& vm, Slot* args, Robot robot) {
  Result<int> id = Host::of(vm).add_robot(std::make_shared<const Robot>(std::move(robot)));
  if (!id.ok()) return failure_of(vm, "R0630", ArgumentError(id.error().message));
  return give(args, new_host_value(vm, kRobot, RobotRef{*id, &Host::of(vm).cell()}));
}

// What every way to make a robot accepts: base, tool and a name, all optional.
Robot finished(Robot robot, Slot base, Slot tool, Slot name) {
  if (base.o != nullptr) robot = robot.with_base(posc(base).T);
  if (tool.o != nullptr) {
    const auto& value = host_value<ToolValue>(tool);
    robot = value.T_flange_tool ? robot.with_tool_point(*value.T_flange_tool)
                                : robot.with_tool(value.tool);
  }
  if (name.o != nullptr) robot = robot.with_name(std::string(text_value(name)));
  return robot;
}

DhConvention convention_of(std::string_view word) {
  if (word == "standard") return DhConvention::kStandard;
  if (word == "modified") return DhConvention::kModified;
  throw ArgumentError(
      fmt::format("The convention is \"standard\" or \"modified\", not \"{}\".", word));
}

namespace {

InertiaCheck inertia_check_of(std::string_view word) {
  if (word == "rigid") return InertiaCheck::kRigidBody;
  if (word == "published") return InertiaCheck::kPublished;
  throw ArgumentError(
      fmt::format("Inertias are \"rigid\" (of bodies that can exist) or \"published\" (kept as "
                  "they are), not \"{}\".",
                  word));
}

constexpr const char* kKeepInertias =
    "inertias: \"published\" keeps the numbers of a source as they are";

// Meshes are files below the folder of the program.
void check_meshes(Vm& vm, const RobotSpec& spec) {
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    const std::string& mesh = spec.links[i].mesh;
    if (mesh.empty() || Host::of(vm).has_mesh({}, mesh)) continue;
    throw ArgumentError(fmt::format("The mesh \"{}\" of link {} of robot `{}` is not there.", mesh,
                                    i + 1, spec.name));
  }
}

// robot name { joint ...; base: ...; tool: ...; gravity: ...; convention: ... }
Signal robot_block(Vm& vm, Slot* args) try {
  enum { kName, kJoints, kBase, kTool, kGravity, kConvention, kHome, kTcp, kInertias };
  RobotSpec spec;
  spec.name = std::string(text_value(args[kName]));
  spec.source = "declared in the program";
  spec.convention = convention_of(text_value(args[kConvention]));
  bool has_mass = false;
  for (const Slot item : items_value(args[kJoints])) {
    const auto& row = host_value<JointRow>(item);
    spec.joints.push_back(row.joint);
    spec.links.push_back(row.link);
    has_mass = has_mass || row.link.mass != 0.0 || row.link.motor_inertia != 0.0 ||
               !row.link.inertia.isZero(0.0) || !row.link.mesh.empty();
  }
  spec.inertia_check = inertia_check_of(text_value(args[kInertias]));
  check_meshes(vm, spec);
  if (!has_mass) spec.links.clear();
  if (!read_vector3(vm, args[kGravity], kGravity, "gravity", spec.gravity)) return Signal::kFail;
  if (args[kHome].o != nullptr) spec.home = posj(args[kHome]).vector();
  Robot robot = finished(Robot(std::move(spec)), args[kBase], args[kTool], Slot{.o = nullptr});
  if (args[kTcp].o != nullptr) robot = robot.with_tool_point(posc(args[kTcp]).T);
  return add_robot(vm, args, std::move(robot));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error);
}

// A robot from a file in the folder of the program.
Signal robot_from_urdf(Vm& vm, Slot* args) try {
  enum { kPath, kTip, kInertias, kBase, kTool, kName };
  const std::string path(text_value(args[kPath]));
  const Result<std::string> text = Host::of(vm).load_file(path);
  if (!text.ok()) {
    return failure(vm, "R0626",
                   fmt::format("\"{}\" cannot be read: {}", path, text.error().message), kPath);
  }
  UrdfOptions options;
  options.inertia_check = inertia_check_of(text_value(args[kInertias]));
  options.has_mesh = [&](const std::string& mesh) { return Host::of(vm).has_mesh(path, mesh); };
  const Result<Mechanism> mechanism = read_urdf(*text, options);
  if (!mechanism.ok()) {
    UrdfOptions published = options;
    published.inertia_check = InertiaCheck::kPublished;
    const bool inertia_only = read_urdf(*text, published).ok();
    return failure_of(vm, "R0630", ArgumentError(mechanism.error().message), kPath,
                      inertia_only ? kKeepInertias : "");
  }
  const std::string_view tip =
      args[kTip].o != nullptr ? text_value(args[kTip]) : std::string_view();
  Result<RobotSpec> spec = serial_arm(*mechanism, tip);
  if (!spec.ok()) return failure_of(vm, "R0630", ArgumentError(spec.error().message), kPath);
  return add_robot(vm, args,
                   finished(Robot(std::move(spec).value()), args[kBase], args[kTool], args[kName]));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error);
}

template <Robot (*kMake)()>
Signal ready_robot(Vm& vm, Slot* args) try {
  return add_robot(vm, args, finished(kMake(), args[0], args[1], args[2]));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0630", error);
}

Answer<Obj*> default_robot(Vm& vm) {
  const Result<int> id = Host::of(vm).default_robot();
  if (!id.ok()) return failure_of(vm, "R0630", ArgumentError(id.error().message));
  return new_host_value(vm, kRobot, RobotRef{*id, &Host::of(vm).cell()});
}

// ---- tools
// -----------------------------------------------------------------------------------------------------

Signal gripper(Vm& vm, Slot* args) try {
  return give(
      args,
      new_host_value(vm, kTool, ToolValue{parallel_gripper(args[0].d, args[1].d, args[2].d), {}}));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0631", error);
}
Signal suction(Vm& vm, Slot* args) try {
  return give(args, new_host_value(vm, kTool, ToolValue{suction_cup(args[0].d, args[1].d), {}}));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0631", error);
}
Obj* tool_point(Vm& vm, const PosC& p) {
  return new_host_value(vm, kTool, ToolValue{point_tool(), p.T});
}

constexpr std::string_view kReady = "(base: posC?, tool: tool?, name: string?) -> robot";

constexpr NativeFunction kModelFunctions[] = {
    {"robot.joint.revolute",
     "(theta: angle = 0rad, d: length = 0m, a: length = 0m, alpha: angle = 0rad, limits: angle[]?, "
     "maxSpeed: angularSpeed?, maxAccel: angularAccel?, "
     "maxJerk: angularAccel/time?, maxTorque: torque?, mass: mass = 0kg, com: length[]?, inertia: "
     "double[][]?, friction: double[]?, motorInertia: double = 0.0, gear: double = 1.0, mesh: "
     "string?) -> jointRow",
     "A joint that turns, with its Denavit-Hartenberg row; theta is its zero.",
     "joint revolute(d: 400mm, a: 250mm, limits: [-170deg, 170deg])",
     joint_row<JointKind::kRevolute>, nullptr, nullptr, check_revolute_row},
    {"robot.joint.prismatic",
     "(theta: angle = 0rad, d: length = 0m, a: length = 0m, alpha: angle = 0rad, limits: "
     "length[]?, maxSpeed: speed?, maxAccel: accel?, "
     "maxJerk: accel/time?, maxForce: force?, mass: mass = 0kg, com: length[]?, inertia: "
     "double[][]?, friction: double[]?, motorInertia: double = 0.0, gear: double = 1.0, mesh: "
     "string?) -> jointRow",
     "A joint that slides, with its Denavit-Hartenberg row; d is its zero.",
     "joint prismatic(limits: [0mm, 150mm])", joint_row<JointKind::kPrismatic>, nullptr, nullptr,
     check_prismatic_row},
    {"robot{}",
     "(name: string, joint: jointRow[], base: posC?, tool: tool?, gravity: accel[]?, convention: "
     "string = \"standard\", home: posJ?, tcp: posC?, inertias: string = \"rigid\") -> robot",
     "A robot made of joints; tcp: the tool point seen from the flange, if the hand does not say "
     "it; "
     "inertias: \"published\" keeps numbers that no rigid body has.",
     "robot arm { joint revolute(a: 300mm) }", robot_block, nullptr, nullptr, check_robot_block},
    {"urdf",
     "(path: string, tip: string?, inertias: string = \"rigid\", base: posC?, tool: tool?, name: "
     "string?) -> robot",
     "A robot from a description in the program's folder; tip: the link at its end, where the file "
     "has several arms.",
     "urdf(\"arm.urdf\", tip: \"tool0\")", robot_from_urdf},
    def<default_robot>("robot()() -> robot", "The robot that the host supplies.", "joints()",
                       {.check = check_default_robot}),
    {"robots.planar2", kReady, "Two links of 1 m in the vertical x-z plane.", "robots.planar2()",
     ready_robot<make_planar2>, nullptr, nullptr, check_ready_robot<make_planar2>},
    {"robots.planar3", kReady, "Three links in the horizontal plane.", "robots.planar3()",
     ready_robot<make_planar3>, nullptr, nullptr, check_ready_robot<make_planar3>},
    {"robots.anthropomorphic", kReady, "Three turning joints, without a wrist.",
     "robots.anthropomorphic()", ready_robot<make_rrr3>, nullptr, nullptr,
     check_ready_robot<make_rrr3>},
    {"robots.scara", kReady,
     "A SCARA with links of 400 and 300 mm and a 60 mm gripper; the tool points down.",
     "robots.scara()", ready_robot<make_scara>, nullptr, nullptr, check_ready_robot<make_scara>},
    {"robots.scorbot", kReady, "Scorbot-ER 4U, five joints.", "robots.scorbot()",
     ready_robot<make_scorbot>, nullptr, nullptr, check_ready_robot<make_scorbot>},
    {"robots.puma560", kReady, "Unimation Puma 560, six joints.", "robots.puma560()",
     ready_robot<make_puma560>, nullptr, nullptr, check_ready_robot<make_puma560>},
    {"robots.stanford", kReady, "Stanford arm, six joints, the third slides.", "robots.stanford()",
     ready_robot<make_stanford>, nullptr, nullptr, check_ready_robot<make_stanford>},
    {"robots.pa10", kReady, "Mitsubishi PA-10 with seven joints.", "robots.pa10()",
     ready_robot<make_pa10>, nullptr, nullptr, check_ready_robot<make_pa10>},
    {"robots.pa10_6", kReady, "Mitsubishi PA-10 with six joints.", "robots.pa10_6()",
     ready_robot<make_pa10_6>, nullptr, nullptr, check_ready_robot<make_pa10_6>},
    {"robots.irb120", kReady, "ABB IRB 120, six joints.", "robots.irb120()",
     ready_robot<make_irb120>, nullptr, nullptr, check_ready_robot<make_irb120>},
    {"robots.ur3", kReady, "Universal Robots UR3, six joints.", "robots.ur3()",
     ready_robot<make_ur3>, nullptr, nullptr, check_ready_robot<make_ur3>},
    {"robots.ur5", kReady, "Universal Robots UR5, six joints.", "robots.ur5()",
     ready_robot<make_ur5>, nullptr, nullptr, check_ready_robot<make_ur5>},
    {"robots.ur10", kReady, "Universal Robots UR10, six joints.", "robots.ur10()",
     ready_robot<make_ur10>, nullptr, nullptr, check_ready_robot<make_ur10>},
    {"robots.panda", kReady, "Franka Emika Panda, seven joints.", "robots.panda()",
     ready_robot<make_panda>, nullptr, nullptr, check_ready_robot<make_panda>},
    {"robots.iiwa14", kReady, "KUKA LBR iiwa 14 R820, seven joints.", "robots.iiwa14()",
     ready_robot<make_iiwa14>, nullptr, nullptr, check_ready_robot<make_iiwa14>},
    {"robots.arm7", kReady, "A generic arm of seven joints with a shoulder, an elbow and a wrist.",
     "robots.arm7()", ready_robot<make_arm7>, nullptr, nullptr, check_ready_robot<make_arm7>},
    {"parallelGripper", "(stroke: length, length: length = 120mm, force: force = 20N) -> tool",
     "A gripper with two fingers; the tool point is `length` along the flange's z axis.",
     "parallelGripper(stroke: 60mm)", gripper},
    {"suctionCup", "(radius: length, length: length = 60mm) -> tool", "A suction cup.",
     "suctionCup(radius: 15mm)", suction},
    def<tool_point>("tcp(p: posC) -> tool", "A tool point without a hand; it cannot grasp.",
                    "tcp(xyz(z: 50mm))"),
};

}  // namespace

std::span<const NativeFunction> model_functions() { return kModelFunctions; }

}  // namespace armlet::bind
