#include "hand_shapes.hpp"

#include <cmath>

#include "armlet/math/pose.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

// m; estimated from pictures of the Barrett Hand, whose table has no thicknesses
constexpr double kPalmRadius = 0.045, kPalmHeight = 0.066;
constexpr double kLinkRadius = 0.009, kTipRadius = 0.008;

// A rod from the axis of a joint to that of the next one, round at both ends. The joint's frame
// moves with it; the link is along x, after the offset d along z.
LinkShape rod(const Robot& finger, int joint, double radius) {
  const DhRow& row = finger.joint(joint).dh;
  const double turned = row.theta;
  LinkShape shape{.link = joint + 1,
                  .kind = LinkShapeKind::kCapsule,
                  .role = LinkShapeRole::kTool,
                  .radius = radius,
                  .length = row.a};
  const Vector3d along(std::cos(turned), std::sin(turned), 0.0);
  shape.T_link_shape.linear() = rotation_from_z(along);
  shape.T_link_shape.translation() = 0.5 * row.a * along + row.d * Vector3d::UnitZ();
  return shape;
}

}  // namespace

std::vector<LinkShape> hand_shapes(const Robot& robot) {
  std::vector<LinkShape> shapes;
  if (robot.spec().role == RobotRole::kHand) {
    shapes.push_back({.link = 0,
                      .kind = LinkShapeKind::kCylinder,
                      .role = LinkShapeRole::kBase,
                      .T_link_shape = make_translation({0.0, 0.0, 0.5 * kPalmHeight}),
                      .radius = kPalmRadius,
                      .length = kPalmHeight});
    return shapes;
  }
  for (int i = 0; i < robot.n(); ++i)
    shapes.push_back(rod(robot, i, i + 1 == robot.n() ? kTipRadius : kLinkRadius));
  return shapes;
}

}  // namespace armlet
