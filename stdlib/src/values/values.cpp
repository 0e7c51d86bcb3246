#include "values/values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "armlet/cell/cell.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/robot_text.hpp"

namespace armlet::bind {
namespace {

template <class T>
void destroy_as(void* value) {
  static_cast<T*>(value)->~T();
}
template <class T>
void copy_as(const void* from, void* to) {
  new (to) T(*static_cast<const T*>(from));
}
template <class T>
const T& as(const void* value) {
  return *static_cast<const T*>(value);
}

bool equal_posj(const void* a, const void* b) {
  const PosJ& p = as<PosJ>(a);
  const PosJ& q = as<PosJ>(b);
  return p.n == q.n && std::equal(p.q.begin(), p.q.begin() + p.n, q.q.begin());
}
bool equal_posc(const void* a, const void* b) {
  return as<PosC>(a).T.matrix() == as<PosC>(b).T.matrix();
}
bool equal_robot(const void* a, const void* b) { return as<RobotRef>(a).id == as<RobotRef>(b).id; }
bool equal_finger(const void* a, const void* b) {
  return as<FingerRef>(a).id == as<FingerRef>(b).id;
}
bool equal_object(const void* a, const void* b) {
  return as<ObjectRef>(a).name == as<ObjectRef>(b).name;
}
bool equal_frame(const void* a, const void* b) {
  return as<FrameRef>(a).name == as<FrameRef>(b).name;
}

void text_posj(const void* value, std::string& out) { out += posj_text(as<PosJ>(value)); }
void text_posc(const void* value, std::string& out) { out += posc_text(as<PosC>(value)); }
void text_robot(const void* value, std::string& out) {
  const auto& robot = as<RobotRef>(value);
  out += robot_table(*robot.cell->robot(robot.id).model, robot.cell->robot(robot.id).name);
}
void text_object(const void* value, std::string& out) {
  out += fmt::format("object \"{}\"", as<ObjectRef>(value).name);
}
void text_frame(const void* value, std::string& out) {
  out += fmt::format("frame \"{}\"", as<FrameRef>(value).name);
}
void text_finger(const void* value, std::string& out) {
  out += fmt::format("finger {}", as<FingerRef>(value).number);
}
void text_shape(const void* value, std::string& out) {
  out += shape_name(as<ShapeValue>(value).shape);
}
void text_tool(const void*, std::string& out) { out += "tool"; }
void text_row(const void* value, std::string& out) {
  out += as<JointRow>(value).joint.is_revolute() ? "revolute joint" : "prismatic joint";
}

void text_body_row(const void*, std::string& out) { out += "shape of a link"; }

// The orientation as text: about one axis if it is a rotation about x, y or z; otherwise as roll,
// pitch and yaw.
std::string orientation_text(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d phi = rotation_log(R);
  const double angle = phi.norm();
  if (angle < 1e-9) return "0 deg about z";
  for (int i = 0; i < 3; ++i) {
    if (std::abs(std::abs(phi[i]) - angle) < 1e-9 * std::max(1.0, angle)) {
      // A rotation by 180 deg is the same in both directions.
      const std::string turn = format_deg(phi[i]);
      return fmt::format("{} about {}", turn == "-180 deg" ? "180 deg" : turn, "xyz"[i]);
    }
  }
  const Eigen::Vector3d rpy = rpy_from_R(R) * (180.0 / std::numbers::pi);
  return fmt::format("rpy {} deg", format_vector(rpy, 1));
}

}  // namespace

const HostType kPosJ{.name = "posJ",
                     .size = sizeof(PosJ),
                     .equal = equal_posj,
                     .text = text_posj,
                     .help = "Joint values.",
                     .copy = copy_as<PosJ>};
const HostType kPosC{.name = "posC",
                     .size = sizeof(PosC),
                     .equal = equal_posc,
                     .text = text_posc,
                     .help = "A place and orientation in space.",
                     .copy = copy_as<PosC>};
namespace {

std::string arm_called(std::string_view name) {
  return name == "arm" ? "the arm" : fmt::format("the {} arm", name);
}

// The words that messages use for a robot.
constexpr ResourceWords kRobotWords{
    .plural = "robots",
    .act = "move",
    .acts = "the moves",
    .act_on_one = "move the robot",
    .busy = "is already moving",
    .still = "still moving",
    .begun = "the robot had started to move",
    .not_begun = "nothing has moved",
    .called = arm_called,
    .not_in_path = {"this motion cannot be part of a `path`",
                    "a path joins lines and arcs of the hand and moves of the joints",
                    "use moveL, moveCirc or moveJ here, or move this line out of the path"},
    .two_in_path = {"a `path` moves one robot", "the path is one motion of that robot",
                    "give each robot its own path, side by side in `parallel`"},
};

}  // namespace

Resource robot_called(std::string name) { return {&kRobot, std::move(name)}; }

const HostType kRobot{.name = "robot",
                      .size = sizeof(RobotRef),
                      .is_handle = true,
                      .is_ambient = true,
                      .equal = equal_robot,
                      .text = text_robot,
                      .help = "A robot of this cell.",
                      .resource = &kRobotWords};
const HostType kFinger{.name = "finger",
                       .size = sizeof(FingerRef),
                       .is_handle = true,
                       .equal = equal_finger,
                       .text = text_finger,
                       .help = "A finger of a hand.",
                       .noun = "a finger of a hand"};
const HostType kObject{.name = "object",
                       .size = sizeof(ObjectRef),
                       .is_handle = true,
                       .destroy = destroy_as<ObjectRef>,
                       .equal = equal_object,
                       .text = text_object,
                       .help = "An object of the world."};
const HostType kFrame{.name = "frame",
                      .size = sizeof(FrameRef),
                      .is_handle = true,
                      .destroy = destroy_as<FrameRef>,
                      .equal = equal_frame,
                      .text = text_frame,
                      .help = "A frame with a name, which moves with what it is on."};
const HostType kShape{.name = "shape",
                      .size = sizeof(ShapeValue),
                      .destroy = destroy_as<ShapeValue>,
                      .text = text_shape,
                      .help = "A box, cylinder, sphere, cone or plane."};
const HostType kTool{.name = "tool",
                     .size = sizeof(ToolValue),
                     .destroy = destroy_as<ToolValue>,
                     .text = text_tool,
                     .help = "What is mounted on the flange."};
const HostType kJointRow{.name = "jointRow",
                         .size = sizeof(JointRow),
                         .destroy = destroy_as<JointRow>,
                         .text = text_row,
                         .help = "One joint of a robot block."};
const HostType kBodyRow{.name = "bodyRow",
                        .size = sizeof(BodyRow),
                        .destroy = destroy_as<BodyRow>,
                        .text = text_body_row,
                        .help = "One shape of a link in a robot block."};

PosJ make_posj(const Robot& robot, const Eigen::VectorXd& q) {
  PosJ p;
  p.n = static_cast<std::uint8_t>(q.size());
  p.kinds_known = q.size() == robot.n();
  for (int i = 0; i < p.n; ++i) {
    p.q[i] = q[i];
    p.turns[i] = p.kinds_known && robot.is_revolute(i);
  }
  return p;
}

Obj* new_posj(Vm& vm, const PosJ& q) { return new_host_value(vm, kPosJ, q); }
Obj* new_posc(Vm& vm, const PosC& p) { return new_host_value(vm, kPosC, p); }

std::string posc_text(const PosC& p) {
  std::string text = format_point_mm(p.T.translation());
  if (p.has_orientation) text += ", " + orientation_text(p.T.linear());
  return text;
}

std::string posj_text(const PosJ& q) {
  std::string text = "posJ(";
  for (int i = 0; i < q.n; ++i) {
    if (i > 0) text += ", ";
    if (!q.kinds_known) {
      text += format_number(q.q[i], 6);
    } else {
      text += q.turns[i] ? format_deg(q.q[i]) : format_mm(q.q[i]);
    }
  }
  return text + ")";
}

}  // namespace armlet::bind
