#include "armlet/stdlib/robot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "values/robots/hand_text.hpp"
#include "values/robots/own_pairs.hpp"

namespace armlet {
namespace {

// The fewest digits that are read back as the same bits, with a point or an exponent.
std::string real(double x) {
  std::string text = fmt::format("{}", x == 0.0 ? 0.0 : x);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

// 0.4 m is "0.4m": an SI unit changes no bits.
std::string with_unit(double x, std::string_view unit) {
  return fmt::format("{}{}", x == 0.0 ? 0.0 : x, unit);
}

// In degrees if they are read back as the same bits, otherwise in rad.
std::string angle(double x, std::string_view per = {}) {
  const double degrees = std::round(rad_to_deg(x) * 1e6) / 1e6;
  std::string text = with_unit(std::abs(degrees), fmt::format("deg{}", per));
  const std::optional<Quantity> read = parse_quantity(text);
  if (!read || read->si != std::abs(x)) return with_unit(x, fmt::format("rad{}", per));
  return degrees < 0.0 ? "-" + text : text;
}

std::string of_joint(const Joint& joint, double x, std::string_view per = {}) {
  return joint.is_revolute() ? angle(x, per) : with_unit(x, fmt::format("m{}", per));
}

std::string list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string vector_text(const Eigen::Vector3d& v, std::string_view unit) {
  std::vector<std::string> items;
  for (int i = 0; i < 3; ++i) items.push_back(with_unit(v[i], unit));
  return list(items);
}

std::string inertia_text(const Eigen::Matrix3d& I) {
  std::vector<std::string> rows;
  for (int i = 0; i < 3; ++i) {
    rows.push_back(list({real(I(i, 0)), real(I(i, 1)), real(I(i, 2))}));
  }
  return list(rows);
}

std::string pose_text(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d p = T.translation();
  const std::string place = fmt::format("x: {}, y: {}, z: {}", with_unit(p.x(), "m"),
                                        with_unit(p.y(), "m"), with_unit(p.z(), "m"));
  if (T.linear().isIdentity(0.0)) return fmt::format("xyz({})", place);
  const Eigen::Vector3d rpy = rpy_from_R(T.linear());
  return fmt::format("pose({}, roll: {}, pitch: {}, yaw: {})", place, angle(rpy.x()),
                     angle(rpy.y()), angle(rpy.z()));
}

std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '"' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
  return '"' + out + '"';
}

void add_link(std::vector<std::string>& parts, const Link& link) {
  const auto add = [&](std::string_view name, const std::string& value) {
    parts.push_back(fmt::format("{}: {}", name, value));
  };
  if (link.mass != 0.0) add("mass", with_unit(link.mass, "kg"));
  if (!link.com.isZero(0.0)) add("com", vector_text(link.com, "m"));
  if (!link.inertia.isZero(0.0)) add("inertia", inertia_text(link.inertia));
  const Friction& f = link.friction;
  if (f.stribeck_speed != 0.0) {
    add("friction", list({real(f.viscous), real(f.coulomb_plus), real(f.coulomb_minus),
                          real(f.static_torque), real(f.stribeck_speed)}));
  } else if (f.coulomb_plus != 0.0 || f.coulomb_minus != 0.0) {
    add("friction", list({real(f.viscous), real(f.coulomb_plus), real(f.coulomb_minus)}));
  } else if (f.viscous != 0.0) {
    add("friction", list({real(f.viscous)}));
  }
  if (link.motor_inertia != 0.0) add("motorInertia", real(link.motor_inertia));
  if (link.gear != 1.0) add("gear", real(link.gear));
  if (!link.mesh.empty()) {
    add("mesh", quoted(link.mesh));
    if (link.mesh_unit != 0.0) add("meshUnit", with_unit(link.mesh_unit, "m"));
    if (link.mesh_scale != 1.0) add("meshScale", real(link.mesh_scale));
  }
}

std::string joint_text(const Joint& joint, const Link& link) {
  std::vector<std::string> parts;
  const auto add = [&](std::string_view name, const std::string& value) {
    parts.push_back(fmt::format("{}: {}", name, value));
  };
  if (joint.dh.theta != 0.0) add("theta", angle(joint.dh.theta));
  if (joint.dh.d != 0.0) add("d", with_unit(joint.dh.d, "m"));
  if (joint.dh.a != 0.0) add("a", with_unit(joint.dh.a, "m"));
  if (joint.dh.alpha != 0.0) add("alpha", angle(joint.dh.alpha));
  add("limits", list({of_joint(joint, joint.lower), of_joint(joint, joint.upper)}));
  add("maxSpeed", of_joint(joint, joint.max_speed, "/s"));
  add("maxAccel", of_joint(joint, joint.max_accel, "/s^2"));
  add("maxJerk", of_joint(joint, joint.max_jerk, "/s^3"));
  if (std::isfinite(joint.max_effort)) {
    add(joint.is_revolute() ? "maxTorque" : "maxForce",
        with_unit(joint.max_effort, joint.is_revolute() ? "Nm" : "N"));
  }
  add_link(parts, link);
  return fmt::format("    joint {}({})\n", joint.is_revolute() ? "revolute" : "prismatic",
                     fmt::join(parts, ", "));
}

std::string_view use_text(LinkSolidUse use) {
  return use == LinkSolidUse::kPicture     ? ", use: \"picture\""
         : use == LinkSolidUse::kCollision ? ", use: \"collision\""
                                           : "";
}

// The boxes, cylinders and spheres of a link, and the mesh of a base.
//
// T_frame_body  pose of the frame of its shapes, in the frame that the block uses.
std::string body_text(int number, const Link& link, const Eigen::Isometry3d& T_frame_body) {
  const std::string of = number == 0 ? std::string() : fmt::format(", link: {}", number);
  std::string text;
  const auto add = [&](std::string_view what, const Eigen::Isometry3d& T, LinkSolidUse use) {
    const Eigen::Isometry3d at = T_frame_body * T;
    const bool is_there = at.isApprox(Eigen::Isometry3d::Identity(), 0.0);
    text += fmt::format("    body {}{}{}{})\n", what, of,
                        is_there ? std::string() : ", at: " + pose_text(at), use_text(use));
  };
  for (const LinkSolid& each : link.solids) {
    const Eigen::Vector3d& s = each.size;
    switch (each.kind) {
      case LinkSolidKind::kBox:
        add(fmt::format("box({}, {}, {}", with_unit(s[0], "m"), with_unit(s[1], "m"),
                        with_unit(s[2], "m")),
            each.T_link_solid, each.use);
        break;
      case LinkSolidKind::kCylinder:
        add(fmt::format("cylinder({}, {}", with_unit(s[0], "m"), with_unit(s[1], "m")),
            each.T_link_solid, each.use);
        break;
      case LinkSolidKind::kSphere:
        add(fmt::format("sphere({}", with_unit(s[0], "m")), each.T_link_solid, each.use);
        break;
    }
  }
  // The meshes of other links are in the rows of their joints.
  if (number == 0 && !link.mesh.empty()) {
    add("mesh(" + quoted(link.mesh),
        link.bodies.empty() ? Eigen::Isometry3d::Identity() : link.bodies.front().T_link_mesh,
        link.bodies.empty() ? LinkSolidUse::kBoth : link.bodies.front().use);
  }
  return text;
}

std::string tool_text(const Tool& tool) {
  switch (tool.kind) {
    case ToolKind::kParallelGripper:
      return fmt::format("    tool: parallelGripper(stroke: {}, length: {}, force: {})\n",
                         with_unit(tool.stroke, "m"), with_unit(tool.length, "m"),
                         with_unit(tool.force, "N"));
    case ToolKind::kSuctionCup:
      return fmt::format("    tool: suctionCup(radius: {}, length: {})\n",
                         with_unit(tool.radius, "m"), with_unit(tool.length, "m"));
    case ToolKind::kPoint:
    case ToolKind::kFingers:
    case ToolKind::kNone:
      break;
  }
  return {};
}

// Replaces characters other than letters, digits and underscores, and a digit at the start.
std::string identifier(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    out += good ? c : '_';
  }
  if (out.empty() || (out[0] >= '0' && out[0] <= '9') || out[0] == '_') out.insert(0, "robot_");
  return out;
}

}  // namespace

std::string robot_block(const Robot& robot) {
  const RobotSpec& spec = robot.spec();
  std::string text = fmt::format("// {}\nrobot {} {{\n", robot.source(), identifier(robot.name()));
  if (spec.followers != nullptr)
    text += "    // masses of links whose joints copy joints of the arm are not in this block\n";
  for (int i = 0; i < robot.n(); ++i) text += joint_text(robot.joint(i), robot.link(i));
  text += body_text(0, robot.body(0), spec.T_base_first.inverse());
  for (int i = 1; i <= robot.n(); ++i)
    text += body_text(i, robot.body(i), Eigen::Isometry3d::Identity());
  if (spec.convention == DhConvention::kModified) text += "    convention: \"modified\"\n";
  if (spec.inertia_check == InertiaCheck::kPublished) text += "    inertias: \"published\"\n";
  // A block has no frame between the base and its first row.
  const Eigen::Isometry3d& T_world_first = robot.chain().T_world_base;
  if (!T_world_first.isApprox(Eigen::Isometry3d::Identity(), 0.0)) {
    text += fmt::format("    base: {}\n", pose_text(T_world_first));
  }
  if (spec.gravity != Eigen::Vector3d(0.0, 0.0, -9.81)) {
    text += fmt::format("    gravity: {}\n", vector_text(spec.gravity, "m/s^2"));
  }
  text += tool_text(spec.tool);
  const bool has_hand = spec.tool.can_grasp();
  Eigen::Isometry3d T_hand = Eigen::Isometry3d::Identity();
  if (has_hand) T_hand.translation().z() = spec.tool.length;
  if (!spec.T_flange_tool.isApprox(T_hand, 0.0)) {
    text += fmt::format("    tcp: {}\n", pose_text(spec.T_flange_tool));
  }
  text += bind::own_pairs_rows(robot);
  std::vector<std::string> home;
  for (int i = 0; i < robot.n(); ++i) home.push_back(of_joint(robot.joint(i), robot.home()[i]));
  text += fmt::format("    home: posJ({})\n}}\n", fmt::join(home, ", "));
  return text;
}

namespace {

std::string degrees(double x) { return format_number(rad_to_deg(x), 4) + " deg"; }
std::string millimetres(double x) { return format_number(x * 1000.0, 3) + " mm"; }

using Line = std::array<std::string, 8>;

// The line of row k; a mimic joint has no joint number.
Line line_of(const Robot& robot, int k) {
  const Joint& joint = robot.row(k);
  const auto value = joint.is_revolute() ? degrees : millimetres;
  const std::string copies = copy_text(robot, k);
  const std::string number =
      copies.empty() ? std::to_string(motion_of_row(robot, k).joint + 1) : std::string("-");
  return {fmt::format("{} {}", number, joint.is_revolute() ? 'R' : 'P'),
          degrees(joint.dh.theta),
          millimetres(joint.dh.d),
          millimetres(joint.dh.a),
          degrees(joint.dh.alpha),
          joint.is_continuous() ? "no limit" : value(joint.lower),
          joint.is_continuous() ? "no limit" : value(joint.upper),
          copies};
}

}  // namespace

std::string robot_table(const Robot& robot, std::string_view name) {
  if (robot.spec().role == RobotRole::kHand)
    return bind::hand_table(robot, name.empty() ? robot.name() : name);
  std::vector<Line> lines = {{"joint", "theta", "d", "a", "alpha", "from", "to", "copies"}};
  for (int k = 0; k < robot.rows(); ++k) lines.push_back(line_of(robot, k));
  const std::size_t columns = robot.coupling() == nullptr ? 7 : 8;
  std::array<std::size_t, 8> width{};
  for (const Line& line : lines) {
    for (std::size_t k = 0; k < columns; ++k) width[k] = std::max(width[k], line[k].size());
  }
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  std::string text = fmt::format("robot {}\n{} DH table", name.empty() ? robot.name() : name,
                                 standard ? "standard" : "modified");
  for (const Line& line : lines) {
    text += fmt::format("\n{:<{}}", line[0], width[0]);
    for (std::size_t k = 1; k < columns && !line[k].empty(); ++k)
      text += fmt::format("  {:>{}}", line[k], width[k]);
  }
  return text;
}

}  // namespace armlet
