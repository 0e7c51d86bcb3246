#include "robot_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/reach.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_coupling.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

double total_mass(const Robot& robot) {
  double mass = 0.0;
  for (int k = 0; k < robot.rows(); ++k) mass += robot.link(k).mass;
  return mass;
}

// ", and 2 joints that copy them"
std::string copying_text(const Robot& robot) {
  const int copies = robot.rows() - robot.n();
  if (copies == 0) return {};
  return fmt::format(", and {} joint{} that cop{} them", copies, copies == 1 ? "" : "s",
                     copies == 1 ? "ies" : "y");
}

// A joint value in deg or mm.
std::string shown(bool turns, double value, int digits) {
  return std::isfinite(value) ? format_number(turns ? rad_to_deg(value) : 1000.0 * value, digits)
                              : "-";
}

// The entry of a row that a joint moves: "q2", "q2 + 90", or "-1 q2 + 90" for a mimic joint.
std::string moved(const Robot& robot, int k, const std::string& zero) {
  const auto [joint, ratio] = motion_of_row(robot, k);
  std::string q = fmt::format("q{}", joint + 1);
  if (!copy_text(robot, k).empty()) q = fmt::format("{} {}", format_number(ratio, 4), q);
  if (zero == "0") return q;
  return zero[0] == '-' ? fmt::format("{} - {}", q, zero.substr(1))
                        : fmt::format("{} + {}", q, zero);
}

std::string rows_text(const Robot& robot) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  std::string text = fmt::format(
      "Denavit-Hartenberg rows, {} convention, {}; deg and mm\n"
      "  joint           theta             d          a      alpha\n",
      standard ? "standard" : "modified",
      standard ? "A = Rz(theta) Tz(d) Tx(a) Rx(alpha)" : "A = Rx(alpha) Tx(a) Rz(theta) Tz(d)");
  for (int k = 0; k < robot.rows(); ++k) {
    const DhRow& row = robot.row(k).dh;
    const bool turns = robot.row(k).is_revolute();
    const std::string copies = copy_text(robot, k);
    const double offset = copies.empty() ? 0.0 : robot.coupling()->offset[k];
    std::string theta = shown(true, row.theta + (turns ? offset : 0.0), 4),
                d = shown(false, row.d + (turns ? 0.0 : offset), 4);
    (turns ? theta : d) = moved(robot, k, turns ? theta : d);
    const std::string number =
        copies.empty() ? std::to_string(motion_of_row(robot, k).joint + 1) : std::string("-");
    text += fmt::format("  {:>2} {:<6} {:>12} {:>13} {:>10} {:>10}\n", number,
                        joint_word(robot.row(k).kind), theta, d, shown(false, row.a, 4),
                        shown(true, row.alpha, 4));
  }
  for (int k = 0; k < robot.rows(); ++k) {
    const std::string copies = copy_text(robot, k);
    if (!copies.empty()) text += fmt::format("  row {} copies {}\n", k + 1, copies);
  }
  return text;
}

std::string limits_text(const Robot& robot) {
  std::string text =
      "limits; deg and mm, per s, s^2 and s^3; N m and N\n"
      "  joint            from            to      speed      accel       jerk     effort\n";
  for (int i = 0; i < robot.n(); ++i) {
    const Joint& joint = robot.joint(i);
    const bool turns = joint.is_revolute();
    const auto limit = [&](double value) {
      return joint.is_continuous() ? std::string("no limit") : shown(turns, value, 3);
    };
    text += fmt::format("  {:>2} {:<6} {:>12} {:>13} {:>10} {:>10} {:>10} {:>10}\n", i + 1,
                        joint_word(joint.kind), limit(joint.lower), limit(joint.upper),
                        shown(turns, joint.max_speed, 1), shown(turns, joint.max_accel, 1),
                        shown(turns, joint.max_jerk, 1),
                        std::isfinite(joint.max_effort) ? format_number(joint.max_effort, 1) : "-");
  }
  return text;
}

std::string pose_text(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d rpy_deg = rpy_from_R(T.linear()) * (180.0 / kPi);
  std::string text = format_point_mm(T.translation());
  if (rpy_deg.norm() > 1e-9) text += fmt::format(", rpy {} deg", format_vector(rpy_deg, 3));
  return text;
}

std::string tool_text(const Robot& robot) {
  const Tool& tool = robot.tool();
  const std::string point =
      fmt::format("tool point at {} of the flange", pose_text(robot.T_flange_tool()));
  switch (tool.kind) {
    case ToolKind::kParallelGripper:
      return fmt::format("parallel gripper opening {}, {}", format_mm(tool.stroke), point);
    case ToolKind::kSuctionCup:
      return fmt::format("suction cup of radius {}, {}", format_mm(tool.radius), point);
    case ToolKind::kPoint:
    case ToolKind::kFingers:
    case ToolKind::kNone:
      break;
  }
  return "none, " + point;
}

std::string home_text(const Robot& robot) {
  std::string text;
  for (int i = 0; i < robot.n(); ++i) {
    if (i > 0) text += ", ";
    text += format_joint_value(robot.joint(i).kind, robot.home()[i]);
  }
  return text;
}

std::string closed_form_text(const ClosedForm& form) {
  if (!form.exists()) return "no closed form is known for this structure; solved numerically";
  std::string text = fmt::format("closed form: {}", to_text(form.kind()));
  if (form.reversed()) text += ", read from the tool to the base";
  if (form.held_joint() >= 0) text += fmt::format(", with joint {} held", form.held_joint() + 1);
  return text;
}

Json pose_json(const Eigen::Isometry3d& T) {
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) {
    Json row = Json::array();
    for (int j = 0; j < 4; ++j) row.push_back(T.matrix()(i, j));
    rows.push_back(row);
  }
  return rows;
}

Json joint_json(const Joint& joint) {
  Json json = {{"kind", joint_word(joint.kind)},
               {"theta", joint.dh.theta},
               {"d", joint.dh.d},
               {"a", joint.dh.a},
               {"alpha", joint.dh.alpha},
               {"lower", joint.lower},
               {"upper", joint.upper},
               {"maxSpeed", joint.max_speed},
               {"maxAccel", joint.max_accel},
               {"maxJerk", joint.max_jerk}};
  if (std::isfinite(joint.max_effort)) json["maxEffort"] = joint.max_effort;
  return json;
}

// The actuator of a joint: "f1", "1/3 f1 + 40 deg".
std::string drive_text(const Mechanism& m, int joint, bool turns) {
  std::string text;
  for (Eigen::Index a = 0; a < m.spec().coupling.cols(); ++a) {
    const double ratio = m.spec().coupling(joint, a);
    if (ratio == 0.0) continue;
    if (!text.empty()) text += " + ";
    if (ratio != 1.0) text += format_number(ratio, 4) + " ";
    text += m.actuators()[static_cast<std::size_t>(a)].name;
  }
  const double offset = m.spec().offset[joint];
  if (offset != 0.0) text += " + " + shown(turns, offset, 4);
  return text.empty() ? "still" : text;
}

// Whether an actuator rotates; its first joint decides.
bool turns(const Mechanism& m, std::size_t actuator) {
  for (int j = 0; j < m.joint_count(); ++j) {
    const int body = m.moving()[static_cast<std::size_t>(j)];
    if (m.spec().coupling(j, static_cast<Eigen::Index>(actuator)) != 0.0) {
      return m.bodies()[static_cast<std::size_t>(body)].joint == BodyJoint::kRevolute;
    }
  }
  return true;
}

}  // namespace

std::string kinds_of(const Robot& robot) {
  std::string word;
  for (int i = 0; i < robot.n(); ++i) word += robot.is_revolute(i) ? 'R' : 'P';
  return word;
}

std::string robot_text(const Robot& robot) {
  const Reach reach = find_reach(robot);
  std::string text = fmt::format("{}: {} joints, {}{}\nsource: {}\n\n{}\n{}\n", robot.name(),
                                 robot.n(), kinds_of(robot), copying_text(robot), robot.source(),
                                 rows_text(robot), limits_text(robot));
  text += fmt::format("base                {}\n", pose_text(robot.T_world_base()));
  text += fmt::format("hand                {}\n", tool_text(robot));
  text += fmt::format("home                {}\n", home_text(robot));
  text += fmt::format(
      "reach               {} from the base{}\n", format_mm(reach.from_base),
      robot.is_revolute(0) ? fmt::format(", {} from axis 1", format_mm(reach.from_axis)) : "");
  text += fmt::format("inverse kinematics  {}\n", closed_form_text(closed_form(robot)));
  const double mass = total_mass(robot);
  text += fmt::format("moving mass         {}\n",
                      mass > 0.0 ? format_number(mass, 3) + " kg" : "not given by the source");
  return text;
}

// In SI; angles in rad.
std::string robot_json(const Robot& robot) {
  const Reach reach = find_reach(robot);
  const ClosedForm& form = closed_form(robot);
  Json joints = Json::array();
  for (int k = 0; k < robot.rows(); ++k) {
    joints.push_back(joint_json(robot.row(k)));
    if (robot.coupling() == nullptr) continue;
    const auto [joint, ratio] = motion_of_row(robot, k);
    joints.back()["moves"] = {
        {"joint", joint + 1}, {"ratio", ratio}, {"offset", robot.coupling()->offset[k]}};
  }
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  const Json json = {{"name", robot.name()},
                     {"source", robot.source()},
                     {"convention", standard ? "standard" : "modified"},
                     {"joints", joints},
                     {"base", pose_json(robot.T_world_base())},
                     {"tool", pose_json(robot.T_flange_tool())},
                     {"home", std::vector<double>(robot.home().begin(), robot.home().end())},
                     {"reach", {{"fromBase", reach.from_base}, {"fromAxis1", reach.from_axis}}},
                     {"closedForm", form.exists() ? Json(to_text(form.kind())) : Json(nullptr)},
                     {"movingMass", total_mass(robot)}};
  return json.dump() + "\n";
}

std::string hand_text(const Hand& hand) {
  std::string text = fmt::format("{}\nsource: {}\n", hand.name, hand.source);
  if (hand.tool.kind == ToolKind::kSuctionCup) {
    text += fmt::format("\nsuction cup of radius {}, tool point {} before the flange\n",
                        format_mm(hand.tool.radius), format_mm(hand.tool.length));
  }
  if (hand.tool.kind == ToolKind::kParallelGripper) {
    text += fmt::format(
        "\nparallel gripper opening {}, force {} N, tool point {} before the flange\n",
        format_mm(hand.tool.stroke), format_number(hand.tool.force), format_mm(hand.tool.length));
  }
  if (!hand.mechanism) return text;
  const Mechanism& m = *hand.mechanism;
  text += "\nactuators; deg and mm\n  name                     from            to\n";
  for (std::size_t a = 0; a < m.actuators().size(); ++a) {
    const Actuator& actuator = m.actuators()[a];
    text +=
        fmt::format("  {:<16} {:>12} {:>13}\n", actuator.name,
                    shown(turns(m, a), actuator.lower, 3), shown(turns(m, a), actuator.upper, 3));
  }
  text += "\njoints\n  joint                link                 on                   moves with\n";
  for (int j = 0; j < m.joint_count(); ++j) {
    const Body& body =
        m.bodies()[static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(j)])];
    const std::string& parent = body.parent < 0
                                    ? m.spec().base_name
                                    : m.bodies()[static_cast<std::size_t>(body.parent)].name;
    text += fmt::format("  {:<20} {:<20} {:<20} {}\n", body.joint_name, body.name, parent,
                        drive_text(m, j, body.joint == BodyJoint::kRevolute));
  }
  return text;
}

}  // namespace armlet::cli
