#include "armlet/collision/arm_solids.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/kinematics/forward.hpp"
#include "collision/table_axes.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

constexpr double kStick = 0.003;    // m, radius
constexpr double kNoLength = 0.03;  // m, a shorter gripper counts as none
constexpr double kHandRoom = 0.15;  // m, room for the unknown gripper of an arm without one

// Shortens the rod of a prismatic joint, whose range is inside of its sleeve, to the end of the
// link.
void cut_rod(const Robot& robot, const LinkShape& shape, Solid& solid) {
  const Eigen::Isometry3d T_link_next =
      T_frame_link(robot, shape.link).inverse() * T_frame_axis(robot, shape.link);
  const double middle = solid.T.translation().z();
  const double low = middle - solid.half.z();
  const double high =
      std::min(middle + solid.half.z(), std::max(T_link_next.translation().z(), 0.0));
  solid.T.translation().z() = 0.5 * (low + high);
  solid.half.z() = 0.5 * (high - low);
}

// Whether a shape is left out: the flange, and a gripper of no length.
bool is_left_out(const LinkShape& shape, bool bare) {
  return shape.role == LinkShapeRole::kMark || (bare && shape.role == LinkShapeRole::kFlange) ||
         (bare && is_hand(shape.role));
}

// Shortens a rod along its axis, to the plane through the tool point across the tool's axis.
//
// T_body_tool  pose of the tool point in the frame that the body is fixed to.
void make_stick(Solid& solid, const Eigen::Isometry3d& T_body_tool) {
  const Eigen::Vector3d along = solid.T.linear().col(2);
  const Eigen::Vector3d out = T_body_tool.linear().col(2);
  const auto beyond = [&](double z) {
    return (solid.T.translation() + z * along - T_body_tool.translation()).dot(out);
  };
  constexpr double kSame = 1e-9;  // m
  double low = -solid.half.z(), high = solid.half.z();
  const double at_low = beyond(low), at_high = beyond(high);
  if (at_low > kSame && at_high > kSame) {
    solid = {};
    return;
  }
  const double cut = low + (high - low) * at_low / (at_low - at_high);
  if (at_high > kSame) high = cut;
  if (at_low > kSame) low = cut;
  solid.T.translation() += 0.5 * (low + high) * along;
  solid = {.core = Solid::Core::kSegment,
           .half = {0.0, 0.0, 0.5 * (high - low)},
           .margin = kStick,
           .T = solid.T};
}

// Upper bound of the distance from the origin of frame k to the tool point, with prismatic joints
// retracted.
double way_to_tool(const Robot& robot, int k) {
  double way = robot.T_flange_tool().translation().norm();
  for (int i = k; i < robot.n(); ++i) {
    const DhRow& row = robot.joint(i).dh;
    double d = row.d;
    if (!robot.is_revolute(i)) d = std::max({0.0, d + robot.lower()[i], -d - robot.upper()[i]});
    way += std::sqrt(row.a * row.a + d * d);
  }
  return way;
}

// Cuts off the part of a body, along its axis, that is nearer to a point of its frame than `room`.
void clear_room(Solid& solid, const Eigen::Vector3d& p, double room) {
  const Eigen::Vector3d along = solid.T.linear().col(2);
  const Eigen::Vector3d middle = solid.T.translation() - p;
  double low = -solid.half.z(), high = solid.half.z();
  const bool is_low_in = (middle + low * along).norm() < room;
  const bool is_high_in = (middle + high * along).norm() < room;
  if (is_low_in && is_high_in) {
    solid = {};
    return;
  }
  if (!is_low_in && !is_high_in) return;
  // The part of the axis inside the ball of that radius.
  const double foot = -middle.dot(along);
  const double off = (middle + foot * along).squaredNorm();
  const double half_chord = std::sqrt(std::max(room * room - off, 0.0));
  if (is_high_in) high = std::min(high, foot - half_chord);
  if (is_low_in) low = std::max(low, foot + half_chord);
  solid.T.translation() += 0.5 * (low + high) * along;
  solid.half.z() = 0.5 * std::max(high - low, 0.0);
}

// Leaves room around both ends of the link that moves with frame k.
void leave_room_for_hand(const Robot& robot, int k, Solid& solid) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  const int first = standard ? k - 1 : k;
  const Eigen::Vector3d ends[] = {
      standard ? T_frame_link(robot, k).translation() : Eigen::Vector3d(Eigen::Vector3d::Zero()),
      T_frame_axis(robot, k).translation()};
  for (int i = 0; i < 2; ++i) {
    const double room = kHandRoom - way_to_tool(robot, first + i);
    if (room > 0.0) clear_room(solid, ends[i], room + solid.margin);
  }
}

bool is_still(const Robot& robot, const LinkShape& shape) {
  if (shape.link == 0) return true;
  if (shape.link > 1 || !robot.is_revolute(0) || shape.kind == LinkShapeKind::kBox) return false;
  const Eigen::Isometry3d& T = shape.T_link_shape;
  return T.translation().head<2>().norm() + T.linear().col(2).head<2>().norm() < 1e-9;
}

// A tool that is a point alone becomes a thin rod from the flange to it.
void add_needle(const Robot& robot, std::vector<ArmSolid>& bodies) {
  constexpr double kThin = 5e-4;  // m
  const Eigen::Vector3d& p = robot.T_flange_tool().translation();
  const double length = p.norm();
  if (robot.tool().kind != ToolKind::kPoint || length < 2.0 * kThin) return;
  ArmSolid needle{.frame = robot.n(), .role = LinkShapeRole::kTool};
  needle.solid = {
      .core = Solid::Core::kSegment, .half = {0.0, 0.0, 0.5 * length - kThin}, .margin = kThin};
  needle.solid.T.linear() = rotation_from_z(p);
  needle.solid.T.translation() = 0.5 * p;
  bodies.push_back(needle);
}

Solid solid_of(const LinkSolid& body) {
  Solid solid;
  switch (body.kind) {
    case LinkSolidKind::kBox:
      solid = {.core = Solid::Core::kBox, .half = 0.5 * body.size};
      break;
    case LinkSolidKind::kCylinder:
      solid = {.core = Solid::Core::kCylinder,
               .half = {body.size.x(), body.size.x(), 0.5 * body.size.y()}};
      break;
    case LinkSolidKind::kSphere:
      solid = {.margin = body.size.x()};
      break;
  }
  return solid;
}

// Adds the bodies that were given, not made from the table.
void add_bodies(const Robot& robot, std::vector<ArmSolid>& bodies) {
  for (int link = 0; link <= robot.n(); ++link) {
    const Link& own = robot.body(link);
    const auto add = [&](Solid solid, const Eigen::Isometry3d& T) {
      ArmSolid body{.frame = link, .solid = std::move(solid), .still = link == 0, .given = true};
      if (link == 0) body.role = LinkShapeRole::kBase;
      body.solid.T = T;
      bodies.push_back(std::move(body));
    };
    for (const LinkSolid& each : own.solids) {
      if (each.use != LinkSolidUse::kPicture) add(solid_of(each), each.T_link_solid);
    }
    for (const LinkMesh& each : own.bodies) {
      if (each.use != LinkSolidUse::kPicture) add(solid_of(*each.triangles), each.T_link_mesh);
    }
  }
}

// Grippers and fingers have the bodies with which they are drawn.
bool ends_bare(const Robot& robot) {
  return robot.spec().role == RobotRole::kArm && robot.tool().length < kNoLength;
}

// Whether a shape is only drawn: that of a link whose bodies were given, or the column of an arm
// without a described base, which is an assumption.
bool is_picture(const Robot& robot, const LinkShape& shape) {
  if (shape.link == 0) return robot.spec().role == RobotRole::kArm;
  if (shape.role == LinkShapeRole::kFlange) return robot.body(robot.n()).has_shape();
  return shape.link <= robot.n() && robot.body(shape.link).has_shape();
}

std::vector<ArmSolid> bodies_of(const Robot& robot, bool bare) {
  const std::vector<Eigen::Isometry3d> frames = link_frames(robot, robot.home());
  const Eigen::Isometry3d T_world_tool = forward(robot, robot.home());
  std::vector<ArmSolid> bodies;
  for (const LinkShape& shape : link_shapes(robot)) {
    if (is_left_out(shape, bare) || is_picture(robot, shape)) continue;
    ArmSolid body{.frame = std::min(shape.link, robot.n()),
                  .role = shape.role,
                  .solid = solid_of(shape),
                  .still = is_still(robot, shape)};
    if (body.solid.is_empty()) continue;
    const bool is_rod = shape.link > 0 && shape.role == LinkShapeRole::kLink &&
                        shape.kind == LinkShapeKind::kCylinder &&
                        !robot.is_revolute(shape.link - 1);
    if (is_rod) cut_rod(robot, shape, body.solid);
    body.solid.T = T_frame_link(robot, shape.link) * body.solid.T;
    if (bare && body.frame >= first_on_axis(robot, robot.n())) {
      const Eigen::Isometry3d& T_world_frame = frames[static_cast<std::size_t>(body.frame - 1)];
      make_stick(body.solid, T_world_frame.inverse() * T_world_tool);
    } else if (bare && body.frame > 0) {
      leave_room_for_hand(robot, body.frame, body.solid);
    }
    if (body.solid.is_empty()) continue;
    bodies.push_back(std::move(body));
  }
  add_bodies(robot, bodies);
  if (bare) add_needle(robot, bodies);
  return bodies;
}

std::vector<Solid> pedestal_of(const Robot& robot) {
  std::vector<Solid> pedestal;
  if (robot.spec().role != RobotRole::kArm) return pedestal;
  for (const LinkShape& shape : pedestal_shapes(robot)) {
    if (shape.role != LinkShapeRole::kMark) pedestal.push_back(solid_of(shape));
  }
  return pedestal;
}

// The bodies with half their thickness. Shapes made from a joint table are thicker than most arms:
// a real forearm passes a column that the drawn one would cut.
std::vector<ArmSolid> slimmed(std::vector<ArmSolid> bodies) {
  for (ArmSolid& each : bodies) {
    if (each.given) continue;
    Solid& solid = each.solid;
    if (solid.core == Solid::Core::kSegment) solid.margin *= 0.5;
    if (solid.core == Solid::Core::kCylinder) solid.half.head<2>() *= 0.5;
  }
  return bodies;
}

}  // namespace

ArmSolids::ArmSolids(const Robot& robot)
    : solids_(bodies_of(robot.uncoupled(), ends_bare(robot))),
      slim_(slimmed(solids_)),
      pedestal_(pedestal_of(robot.uncoupled())),
      neighbour_of_last_(first_on_axis(robot.uncoupled(), robot.rows()) - 1),
      is_bare_(ends_bare(robot)) {}

}  // namespace armlet
