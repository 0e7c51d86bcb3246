#include "body_inertia.hpp"

#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Inertia of a unit mass at c about the origin (Huygens and Steiner).
Matrix3d point_inertia(const Vector3d& c) {
  return c.squaredNorm() * Matrix3d::Identity() - c * c.transpose();
}

}  // namespace

Link moved(const Link& link, const Eigen::Isometry3d& T_to_from) {
  Link result;
  result.names = link.names;
  result.mass = link.mass;
  result.com = T_to_from * link.com;
  const Matrix3d R = T_to_from.linear();
  const Matrix3d I = R * link.inertia * R.transpose();
  result.inertia = 0.5 * (I + I.transpose());
  result.mesh = link.mesh;
  result.bodies = link.bodies;
  for (LinkMesh& each : result.bodies) each.T_link_mesh = T_to_from * each.T_link_mesh;
  result.solids = link.solids;
  for (LinkSolid& each : result.solids) each.T_link_solid = T_to_from * each.T_link_solid;
  return result;
}

void add_body(Link& link, const Link& body) {
  if (link.mesh.empty()) link.mesh = body.mesh;
  link.bodies.insert(link.bodies.end(), body.bodies.begin(), body.bodies.end());
  link.solids.insert(link.solids.end(), body.solids.begin(), body.solids.end());
  link.names.insert(link.names.end(), body.names.begin(), body.names.end());
  if (link.mass + body.mass == 0.0) {
    link.inertia += body.inertia;
    if (link.com.isZero()) link.com = body.com;
    return;
  }
  if (link.mass == 0.0 && link.inertia.isZero()) {
    link.com = body.com;
    link.inertia = body.inertia;
    link.mass = body.mass;
    return;
  }
  if (body.mass == 0.0) {
    link.inertia += body.inertia;
    return;
  }
  const double mass = link.mass + body.mass;
  const Vector3d com = (link.mass * link.com + body.mass * body.com) / mass;
  link.inertia += body.inertia + link.mass * point_inertia(link.com - com) +
                  body.mass * point_inertia(body.com - com);
  link.com = com;
  link.mass = mass;
}

Payload together(const Payload& a, const Payload& b) {
  Link sum, other;
  sum.mass = a.mass;
  sum.com = a.com;
  sum.inertia = a.inertia;
  other.mass = b.mass;
  other.com = b.com;
  other.inertia = b.inertia;
  add_body(sum, other);
  return {.mass = sum.mass, .com = sum.com, .inertia = sum.inertia};
}

void copy_motor(Link& to, const Link& from) {
  to.motor_inertia = from.motor_inertia;
  to.gear = from.gear;
  to.friction = from.friction;
}

Eigen::Isometry3d joint_motion(const Body& body, double value) {
  switch (body.joint) {
    case BodyJoint::kRevolute:
      return make_pose(R_from_axis_angle(body.axis, value), Vector3d::Zero());
    case BodyJoint::kPrismatic:
      return make_translation(value * body.axis);
    case BodyJoint::kFixed:
      break;
  }
  return Eigen::Isometry3d::Identity();
}

}  // namespace armlet
