#include "armlet/model/link_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hand_shapes.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Thickness of an arm at its base and at its flange, as fractions of its reach.
constexpr double kThickness = 0.060;
constexpr double kThicknessAtEnd = 0.032;

// A frame with z from `from` to `to` and the origin in the middle between them.
Isometry3d between(const Vector3d& from, const Vector3d& to) {
  Isometry3d T = Isometry3d::Identity();
  const Vector3d way = to - from;
  if (way.norm() > 1e-12) T.linear() = rotation_from_z(way);
  T.translation() = 0.5 * (from + to);
  return T;
}

Isometry3d along_z(double z) { return Isometry3d(Eigen::Translation3d(0.0, 0.0, z)); }

// The polyline of a link's body, in the frame of its joint: the joint, the points of its axis and
// of the next one that are nearest to each other, the next joint.
std::array<Vector3d, 4> way_of_link(const Isometry3d& T_joint_next) {
  const Vector3d end = T_joint_next.translation();
  const Vector3d axis = T_joint_next.linear().col(2);
  const double across = 1.0 - axis.z() * axis.z();  // squared sine of the angle between the axes
  double own = end.z();                             // parallel axes: straight across at the end
  double back = 0.0;
  if (across > 1e-6) {
    // (own z) - (end - back axis) is perpendicular to both axes.
    back = (end.dot(axis) - axis.z() * end.z()) / across;
    own = end.z() - back * axis.z();
  }
  return {Vector3d::Zero(), Vector3d(0.0, 0.0, own), end - back * axis, end};
}

class ShapesOfArm {
 public:
  explicit ShapesOfArm(const Robot& robot) : robot_(robot) {}

  std::vector<LinkShape> all() {
    given(0);
    if (!robot_.has_shapes()) base();
    for (int i = 0; i < robot_.n(); ++i) {
      // The shapes from the table represent a link that has only meshes until these are loaded.
      if (!robot_.link(i).draws_solid()) link_of_joint(i);
      given(i + 1);
    }
    flange();
    tool();
    return std::move(shapes_);
  }

  std::vector<LinkShape> pedestal() {
    base();
    return std::move(shapes_);
  }

 private:
  // Outer radius of the link after joint i; -1: of the base.
  [[nodiscard]] double thickness(int i) const {
    const double part = static_cast<double>(std::max(i, 0)) / std::max(1, robot_.n() - 1);
    return robot_.reach() * (kThickness + part * (kThicknessAtEnd - kThickness));
  }

  // From the frame that moves with joint i to that of the next joint at zero, or to the flange.
  [[nodiscard]] Isometry3d T_joint_next(int i) const {
    const bool is_standard = robot_.spec().convention == DhConvention::kStandard;
    Isometry3d T = Isometry3d::Identity();
    if (is_standard && i >= 0) T = dh_pose(DhConvention::kStandard, robot_.joint(i).dh);
    if (!is_standard && i + 1 < robot_.n())
      T = dh_pose(DhConvention::kModified, robot_.joint(i + 1).dh);
    return T;
  }

  // From the frame of shapes of a link to the one in which its body is given.
  [[nodiscard]] Isometry3d T_shapes_body(int link) const {
    const bool is_standard = robot_.spec().convention == DhConvention::kStandard;
    return is_standard && link > 0 ? dh_pose(DhConvention::kStandard, robot_.joint(link - 1).dh)
                                   : Isometry3d::Identity();
  }

  void given(int link) {
    for (const LinkSolid& solid : robot_.body(link).solids) {
      if (solid.use == LinkSolidUse::kCollision) continue;
      const LinkShapeRole role = link == 0 ? LinkShapeRole::kBase : LinkShapeRole::kLink;
      const Isometry3d T = T_shapes_body(link) * solid.T_link_solid;
      switch (solid.kind) {
        case LinkSolidKind::kBox:
          add(link, LinkShapeKind::kBox, role, T).size = solid.size;
          break;
        case LinkSolidKind::kCylinder:
          round(link, LinkShapeKind::kCylinder, role, T, solid.size.x(), solid.size.y());
          break;
        case LinkSolidKind::kSphere:
          round(link, LinkShapeKind::kCapsule, role, T, solid.size.x(), 0.0);
          break;
      }
      shapes_.back().given = true;
    }
  }

  LinkShape& add(int link, LinkShapeKind kind, LinkShapeRole role, const Isometry3d& T) {
    return shapes_.emplace_back(
        LinkShape{.link = link, .kind = kind, .role = role, .T_link_shape = T});
  }
  void round(int link, LinkShapeKind kind, LinkShapeRole role, const Isometry3d& T, double radius,
             double length) {
    LinkShape& shape = add(link, kind, role, T);
    shape.radius = radius;
    shape.length = length;
  }
  void mark(int link, const Isometry3d& T, double radius, double length) {
    LinkShape& shape = add(link, LinkShapeKind::kRing, LinkShapeRole::kMark, T);
    shape.radius = radius;
    shape.length = length;
    shape.thickness = 0.25 * radius;
  }
  void box(LinkShapeRole role, const Isometry3d& T, const Vector3d& size) {
    add(robot_.n() + 1, LinkShapeKind::kBox, role, T).size = size;
  }

  void leg(int link, const Vector3d& from, const Vector3d& to, double radius) {
    const double length = (to - from).norm();
    if (length < 0.05 * radius) return;
    round(link, LinkShapeKind::kCapsule, LinkShapeRole::kLink, between(from, to), radius, length);
  }

  // The housing of the next joint: a sleeve, if that one is prismatic.
  void seat_of_next(int i) {
    if (i + 1 >= robot_.n() || robot_.is_revolute(i + 1)) return;
    const double r = thickness(i + 1);
    round(i + 1, LinkShapeKind::kCylinder, LinkShapeRole::kJoint, T_joint_next(i), 1.1 * r,
          2.6 * r);
    for (const double side : {-1.0, 1.0})
      mark(i + 1, T_joint_next(i) * along_z(side * 1.3 * r), 1.15 * r, 0.2 * r);
  }

  void base() {
    const double r = thickness(-1);
    round(0, LinkShapeKind::kCylinder, LinkShapeRole::kBase, along_z(0.2 * r), 1.6 * r, 0.4 * r);
    const std::array<Vector3d, 4> way = way_of_link(T_joint_next(-1));
    for (std::size_t k = 0; k + 1 < way.size(); ++k) leg(0, way[k], way[k + 1], 1.1 * r);
    seat_of_next(-1);
  }

  void link_of_joint(int i) {
    const std::array<Vector3d, 4> way = way_of_link(T_joint_next(i));
    const double r = thickness(i);
    if (robot_.is_revolute(i)) {
      turning_joint(i, way[1].z());
      leg(i + 1, way[0], way[1], r);
    } else {
      rod(i, way[1].z());
    }
    leg(i + 1, way[1], way[2], r);
    leg(i + 1, way[2], way[3], 0.9 * r);
    seat_of_next(i);
  }

  // Whether the link before reaches joint i along its axis, from below.
  [[nodiscard]] bool comes_along_axis(int i) const {
    const std::array<Vector3d, 4> way = way_of_link(T_joint_next(i - 1));
    return (way[3] - way[2]).norm() > 0.5 * thickness(i) || way[3].norm() < 0.05 * thickness(i);
  }

  // own  height at which the link leaves the axis.
  void turning_joint(int i, double own) {
    const double r = thickness(i);
    if (comes_along_axis(i) && std::abs(own) > 0.5 * r) {
      const double foot = i == 0 ? 0.45 * r : 0.0;
      mark(i + 1, along_z(std::copysign(foot + 0.15 * r, own)), 1.15 * r, 0.3 * r);
      return;
    }
    round(i + 1, LinkShapeKind::kCylinder, LinkShapeRole::kJoint, Isometry3d::Identity(), 1.12 * r,
          2.3 * r);
    for (const double side : {-1.0, 1.0}) mark(i + 1, along_z(side * 1.15 * r), 1.17 * r, 0.18 * r);
  }

  void rod(int i, double own) {
    const double r = thickness(i);
    const double lower = std::min({own, 0.0, -robot_.upper()[i] - 1.6 * r});
    const double upper = std::max({own, 0.0, -robot_.lower()[i] + 1.6 * r});
    round(i + 1, LinkShapeKind::kCylinder, LinkShapeRole::kLink, along_z(0.5 * (lower + upper)),
          0.6 * r, upper - lower);
  }

  void flange() {
    const double r = thickness(robot_.n() - 1);
    round(robot_.n() + 1, LinkShapeKind::kCylinder, LinkShapeRole::kFlange, along_z(-0.15 * r),
          1.05 * r, 0.3 * r);
  }

  // The end of the gripper is the tool point.
  void tool() {
    const Tool& tool = robot_.tool();
    const Isometry3d& T_tip = robot_.T_flange_tool();
    const int link = robot_.n() + 1;
    const double length = std::max(tool.length, 0.02);
    switch (tool.kind) {
      case ToolKind::kNone:
      case ToolKind::kFingers:  // drawn as robots of their own
        break;
      case ToolKind::kParallelGripper:
        gripper(T_tip, length, tool.stroke);
        break;
      case ToolKind::kSuctionCup:
        round(link, LinkShapeKind::kCylinder, LinkShapeRole::kTool, T_tip * along_z(-0.5 * length),
              0.4 * tool.radius, length);
        round(link, LinkShapeKind::kCylinder, LinkShapeRole::kTool, T_tip * along_z(-0.1 * length),
              tool.radius, 0.2 * length);
        break;
      case ToolKind::kPoint:
        round(link, LinkShapeKind::kCylinder, LinkShapeRole::kTool, T_tip * along_z(-0.5 * length),
              0.12 * length, length);
        break;
    }
  }

  void gripper(const Isometry3d& T_tip, double length, double stroke) {
    const double finger = 0.12 * length;
    const double width = stroke + 2.0 * finger;
    box(LinkShapeRole::kTool, T_tip * along_z(-0.78 * length),
        {width, 0.35 * length, 0.44 * length});
    for (const double side : {-1.0, 1.0}) {
      box(side < 0.0 ? LinkShapeRole::kFingerLeft : LinkShapeRole::kFingerRight,
          T_tip * Eigen::Translation3d(side * 0.5 * (stroke + finger), 0.0, -0.28 * length),
          {finger, 0.22 * length, 0.56 * length});
    }
  }

  const Robot& robot_;
  std::vector<LinkShape> shapes_;
};

}  // namespace

std::string_view to_text(LinkShapeKind kind) {
  constexpr std::string_view kWords[] = {"cylinder", "capsule", "ring", "box"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string_view to_text(LinkShapeRole role) {
  constexpr std::string_view kWords[] = {"base", "joint",       "link",         "flange",
                                         "tool", "finger_left", "finger_right", "mark"};
  return kWords[static_cast<std::size_t>(role)];
}

std::vector<LinkShape> pedestal_shapes(const Robot& robot) {
  return ShapesOfArm(robot.uncoupled()).pedestal();
}

std::vector<LinkShape> link_shapes(const Robot& robot) {
  return robot.spec().role == RobotRole::kArm ? ShapesOfArm(robot.uncoupled()).all()
                                              : hand_shapes(robot);
}

}  // namespace armlet
