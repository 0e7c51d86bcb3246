#include "armlet/model/serial_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "body_inertia.hpp"
#include "descriptions/arm_tip.hpp"
#include "descriptions/chain_drives.hpp"
#include "descriptions/followers.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kParallel = 1e-8;

Isometry3d screw_z(double angle, double shift) { return make_pose(rot_z(angle), {0, 0, shift}); }

// M = Rz(theta) Tz(d) Rx(alpha) Tx(a) Rz(rest_angle) Tz(rest_shift): from one joint axis (z) to the
// next along their common normal.
struct Normal {
  double theta = 0.0, d = 0.0, alpha = 0.0, a = 0.0, rest_angle = 0.0, rest_shift = 0.0;
};

// The angle of the normal is between -90 and 90 deg; its direction is given by the signs of alpha
// and a.
Normal common_normal(const Isometry3d& M) {
  const Matrix3d R = M.linear();
  const Vector3d z = R.col(2), p = M.translation();
  Normal normal;
  const double sine = det::hypot(z.x(), z.y());
  if (sine > kParallel) {
    const double side = z.y() > 0.0 || (z.y() == 0.0 && z.x() < 0.0) ? -1.0 : 1.0;
    normal.theta = det::atan2(side * z.x(), -side * z.y());
    normal.alpha = det::atan2(side * sine, z.z());
    const Vector3d at = rot_z(-normal.theta) * p;
    normal.a = at.x();
    normal.rest_shift = -at.y() / (side * sine);
    normal.d = at.z() - normal.rest_shift * z.z();
  } else {
    normal.alpha = z.z() > 0.0 ? 0.0 : det::atan2(0.0, -1.0);
    const double side = p.x() < 0.0 ? -1.0 : 1.0;
    normal.a = side * det::hypot(p.x(), p.y());
    if (std::abs(normal.a) > 1e-12) normal.theta = det::atan2(side * p.y(), side * p.x());
    normal.d = p.z();
  }
  const SinCos alpha = snapped_sin_cos(normal.alpha);
  Matrix3d Rx;
  Rx << 1, 0, 0, 0, alpha.cos, -alpha.sin, 0, alpha.sin, alpha.cos;
  const Matrix3d rest = Rx.transpose() * rot_z(-normal.theta) * R;
  normal.rest_angle = det::atan2(rest(1, 0), rest(0, 0));
  return normal;
}

// A rotation that maps z to an axis, exact for coordinate axes.
Matrix3d R_with_z(const Vector3d& axis) {
  if (axis == Vector3d::UnitZ()) return Matrix3d::Identity();
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  Matrix3d R;
  R.col(2) = axis;
  R.col(0) = Vector3d::Unit(smallest).cross(axis).normalized();
  R.col(1) = axis.cross(R.col(0));
  return R;
}

// The state while the chain is followed.
struct Walk {
  const Mechanism* mechanism;
  std::vector<int> path;  // bodies from the base to the tip
  Isometry3d T_last_tip = Isometry3d::Identity();
  std::string note;
};

bool moves(const Mechanism& m, int body) { return m.joint_of(body) >= 0; }

Result<Walk> walk_to(const Mechanism& m, std::string_view tip) {
  const Result<ArmTip> end = find_arm_tip(m, tip);
  if (!end.ok()) return end.error();
  Walk walk{&m, {}, end->T_body_tip, end->note};
  for (int at = end->body; at >= 0; at = m.bodies()[static_cast<std::size_t>(at)].parent)
    walk.path.push_back(at);
  std::ranges::reverse(walk.path);
  return walk;
}

// The pose of each body in the frame of the nearest moving body of the chain, if there is one.
struct Carried {
  std::vector<int> row;  // of the arm, or -1: it is fixed to the base
  std::vector<Isometry3d> T_row_body;
};

// zero  values of the joints of the mechanism.
Carried carried_by(const Mechanism& m, const std::vector<int>& chain, const Eigen::VectorXd& zero) {
  Carried carried;
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    const auto found = std::ranges::find(chain, static_cast<int>(i));
    if (found != chain.end()) {
      carried.row.push_back(static_cast<int>(found - chain.begin()));
      carried.T_row_body.push_back(Isometry3d::Identity());
      continue;
    }
    const Body& body = m.bodies()[i];
    Isometry3d T = body.T_parent_joint;
    if (const int j = m.joint_of(static_cast<int>(i)); j >= 0) T = T * joint_motion(body, zero[j]);
    if (body.parent >= 0) {
      T = carried.T_row_body[static_cast<std::size_t>(body.parent)] * T;
      carried.row.push_back(carried.row[static_cast<std::size_t>(body.parent)]);
    } else {
      carried.row.push_back(-1);
    }
    carried.T_row_body.push_back(T);
  }
  return carried;
}

// The constant poses between the joints of the path: before the first, between, after the last.
// Frames at joints have the axis as z.
struct Legs {
  std::vector<int> chain;                 // bodies with moving joints
  std::vector<Isometry3d> T_before_axis;  // one per joint
  Isometry3d T_axis_tip = Isometry3d::Identity();
};

Legs legs_of(const Walk& walk) {
  const Mechanism& m = *walk.mechanism;
  Legs legs;
  Isometry3d T = Isometry3d::Identity();
  for (const int i : walk.path) {
    const Body& body = m.bodies()[static_cast<std::size_t>(i)];
    T = T * body.T_parent_joint;
    if (!moves(m, i)) continue;
    const Isometry3d T_joint_axis = make_pose(R_with_z(body.axis), Vector3d::Zero());
    legs.chain.push_back(i);
    legs.T_before_axis.push_back(T * T_joint_axis);
    T = T_joint_axis.inverse();
  }
  legs.T_axis_tip = T * walk.T_last_tip;
  return legs;
}

// The rows of the arm and their drives.
Result<ChainDrives> check_chain(const Mechanism& m, const Legs& legs) {
  if (legs.chain.empty()) {
    return Error{"no_chain",
                 fmt::format("`{}` has no joint between its base `{}` and this link; name the link "
                             "at the end of the arm",
                             m.name(), m.spec().base_name)};
  }
  if (legs.chain.size() > static_cast<std::size_t>(kMaxJoints)) {
    return Error{"too_many_joints",
                 fmt::format("this arm of `{}` has {} joints; an arm has 1 to {}", m.name(),
                             legs.chain.size(), kMaxJoints)};
  }
  return drives_of_chain(m, legs.chain);
}

// Notes the consequences of an inertia that no body has.
void note_inertia(const Mechanism& m, const Body& body, bool is_moved, RobotSpec& spec) {
  if (body.inertia_fault.empty()) return;
  spec.notes.push_back(fmt::format("link `{}` {}; {}", body.name, body.inertia_fault,
                                   is_moved ? "forces are refused, its mass is left out"
                                            : "no joint moves it, so it is left out"));
  if (is_moved && spec.no_dynamics.empty())
    spec.no_dynamics = fmt::format("The forces of robot `{}` cannot be computed: link `{}` {}.",
                                   m.name(), body.name, body.inertia_fault);
}

Link named(Link link, const std::string& name) {
  link.names = {name};
  return link;
}

// The base and the links, each with what is fixed to it.
//
// T_row_axis  for each row, the frame with the joint's axis as z.
// follows     for each body, whether a mimic joint of the arm moves it.
// zero        values of the joints of the mechanism while the arm is at zero.
struct LinkFrames {
  const std::vector<int>& chain;
  const std::vector<Isometry3d>& T_row_axis;
  const std::vector<bool>& follows;
  const Eigen::VectorXd& zero;
};
void add_links(const Mechanism& m, const LinkFrames& frames, RobotSpec& spec) {
  const auto& [chain, T_row_axis, follows, zero] = frames;
  const Carried carried = carried_by(m, chain, zero);
  add_body(spec.base, named(m.spec().base, m.spec().base_name));
  spec.links.resize(chain.size());
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    const Body& body = m.bodies()[i];
    note_inertia(m, body, follows[i] || carried.row[i] >= 0, spec);
    if (follows[i] && (!body.link.bodies.empty() || !body.link.solids.empty()))
      spec.notes.push_back(fmt::format(
          "the shape of link `{}` is where its joint is while the arm is at zero", body.name));
    const Link link = named(follows[i] ? without_mass(body.link) : body.link, body.name);
    if (carried.row[i] < 0) {
      add_body(spec.base, moved(link, carried.T_row_body[i]));
      continue;
    }
    const std::size_t k = static_cast<std::size_t>(carried.row[i]);
    const Body& carrier = m.bodies()[static_cast<std::size_t>(chain[k])];
    const Isometry3d T_row_carrier =
        T_row_axis[k] * make_pose(R_with_z(carrier.axis), Vector3d::Zero()).inverse();
    add_body(spec.links[k], moved(link, T_row_carrier * carried.T_row_body[i]));
    if (static_cast<int>(i) == chain[k] && spec.joints[k].drive.of < 0)
      copy_motor(spec.links[k], body.link);
  }
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const RowDrive& drive = spec.joints[k].drive;
    if (drive.of < 0) continue;
    add_copied_motor(m.bodies()[static_cast<std::size_t>(chain[k])].link, drive.ratio,
                     spec.links[static_cast<std::size_t>(drive.of)]);
  }
}

}  // namespace

Result<RobotSpec> serial_arm(const Mechanism& m, std::string_view tip) {
  const Result<Walk> walk = walk_to(m, tip);
  if (!walk.ok()) return walk.error();
  const Legs legs = legs_of(*walk);
  const Result<ChainDrives> drives = check_chain(m, legs);
  if (!drives.ok()) return drives.error();
  RobotSpec spec;
  spec.name = m.name();
  spec.source = m.source();
  spec.convention = DhConvention::kModified;
  spec.inertia_check = m.spec().inertia_check;
  spec.T_base_first = legs.T_before_axis[0];
  spec.notes = m.spec().notes;
  if (!walk->note.empty()) spec.notes.push_back(walk->note);
  spec.joints = joints_of_chain(m, legs.chain, *drives, spec.notes);

  // The rest of each normal commutes with the joint and becomes a part of the next leg.
  const std::size_t n = spec.joints.size();
  std::vector<Isometry3d> T_row_axis(n, Isometry3d::Identity());  // of the frame with the axis as z
  Isometry3d rest = Isometry3d::Identity();
  for (std::size_t i = 0; i < n; ++i) {
    DhRow& row = spec.joints[i].dh;
    if (i + 1 == n) {
      T_row_axis[i] = rest;
      spec.T_flange_tool = rest * legs.T_axis_tip;
      break;
    }
    const Normal normal = common_normal(rest * legs.T_before_axis[i + 1]);
    row.theta = normal.theta;
    row.d = normal.d;
    T_row_axis[i] = screw_z(normal.theta, normal.d).inverse() * rest;
    spec.joints[i + 1].dh.alpha = normal.alpha;
    spec.joints[i + 1].dh.a = normal.a;
    rest = screw_z(normal.rest_angle, normal.rest_shift);
  }

  const Followers followers = followers_of(m, legs.chain, *drives);
  spec.followers = followers.mechanism;
  add_links(m, {legs.chain, T_row_axis, followers.follows, values_at_zero(m, *drives)}, spec);
  return spec;
}

MechanismSpec mechanism_of(const Robot& robot) {
  MechanismSpec spec;
  spec.name = robot.name();
  spec.source = robot.source();
  spec.base_name = "world";
  spec.inertia_check = robot.spec().inertia_check;
  spec.bodies.push_back({.name = "base",
                         .joint_name = "world_base",
                         .T_parent_joint = robot.T_world_base(),
                         .link = moved(robot.spec().base, Isometry3d::Identity())});
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  // The part after the joint's own motion: the constants of Z, and the X that follows.
  Isometry3d T_link_next = Isometry3d::Identity();
  for (int i = 0; i < robot.rows(); ++i) {
    const Joint& joint = robot.row(i);
    const Isometry3d Z = screw_z(joint.dh.theta, joint.dh.d);
    const Isometry3d X = dh_pose(DhConvention::kStandard, {0.0, 0.0, joint.dh.a, joint.dh.alpha});
    Isometry3d T_parent_joint = standard ? T_link_next : T_link_next * X;
    if (i == 0) T_parent_joint = robot.spec().T_base_first * T_parent_joint;
    T_link_next = standard ? Z * X : Z;
    const std::string number = std::to_string(i + 1);
    spec.bodies.push_back(
        {.name = "link" + number,
         .joint_name = "joint" + number,
         .parent = i,
         .joint = joint.is_revolute() ? BodyJoint::kRevolute : BodyJoint::kPrismatic,
         .T_parent_joint = T_parent_joint,
         .axis = Vector3d::UnitZ(),
         .link = moved(robot.link(i), T_link_next)});
    copy_motor(spec.bodies.back().link, robot.link(i));
    if (joint.drive.of >= 0) continue;
    spec.actuators.push_back(
        {.name = "joint" + number,
         .lower = joint.lower,
         .upper = joint.upper,
         .max_speed = joint.max_speed,
         .max_effort = std::isfinite(joint.max_effort) ? joint.max_effort : 0.0});
  }
  if (const JointCoupling* coupling = robot.coupling()) {
    spec.coupling = coupling->E;
    spec.offset = coupling->offset;
  }
  const int n = robot.rows();
  spec.bodies.push_back(
      {.name = "flange", .joint_name = "link_flange", .parent = n, .T_parent_joint = T_link_next});
  spec.bodies.push_back({.name = "tool",
                         .joint_name = "flange_tool",
                         .parent = n + 1,
                         .T_parent_joint = robot.T_flange_tool()});
  return spec;
}

}  // namespace armlet
