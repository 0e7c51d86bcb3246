#include "chain_drives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "armlet/math/angles.hpp"

namespace armlet {
namespace {

// The joint value is ratio a + offset, with a the value of the actuator.
struct RowActuator {
  Eigen::Index actuator = -1;
  double ratio = 0.0, offset = 0.0;

  bool is_one_to_one() const { return ratio == 1.0 && offset == 0.0; }
};

const Body& body_of(const Mechanism& m, int body) {
  return m.bodies()[static_cast<std::size_t>(body)];
}

// The only actuator of a body's joint; nothing if there are several or none.
std::optional<RowActuator> actuator_of(const Mechanism& m, int body) {
  const int joint = m.joint_of(body);
  const Eigen::MatrixXd& C = m.spec().coupling;
  RowActuator found{.offset = m.spec().offset[joint]};
  for (Eigen::Index a = 0; a < C.cols(); ++a) {
    if (C(joint, a) == 0.0) continue;
    if (found.actuator >= 0) return std::nullopt;
    found.actuator = a;
    found.ratio = C(joint, a);
  }
  if (found.actuator < 0) return std::nullopt;
  return found;
}

// Why a body of the chain cannot belong to an arm, and the end of an arm without it.
Error refused(const Mechanism& m, int body) {
  const Body& at = body_of(m, body);
  const Eigen::RowVectorXd row = m.spec().coupling.row(m.joint_of(body));
  std::string drives;
  for (Eigen::Index a = 0; a < row.size(); ++a) {
    if (row[a] == 0.0) continue;
    drives += fmt::format("{}`{}`", drives.empty() ? "" : " and ",
                          m.actuators()[static_cast<std::size_t>(a)].name);
  }
  const std::string& before = at.parent >= 0 ? body_of(m, at.parent).name : m.spec().base_name;
  return Error{
      "coupled",
      drives.empty()
          ? fmt::format("joint `{}` of `{}` moves with no other joint and has no motor, so it "
                        "cannot belong to an arm; make it fixed, or end the arm before it with "
                        "tip: \"{}\"",
                        at.joint_name, m.name(), before)
          : fmt::format("joint `{}` of `{}` moves with {} together, and a joint of an arm copies "
                        "one joint; tip: \"{}\" ends the arm before it",
                        at.joint_name, m.name(), drives, before)};
}

// Among the rows that an actuator moves, the row that becomes its joint.
std::size_t own_row(const Mechanism& m, const std::vector<int>& chain,
                    const std::vector<RowActuator>& rows, Eigen::Index actuator) {
  const std::string& name = m.actuators()[static_cast<std::size_t>(actuator)].name;
  const auto find = [&](auto&& is_wanted) {
    std::size_t k = 0;
    while (k < rows.size() && !(rows[k].actuator == actuator && is_wanted(k))) ++k;
    return k;
  };
  const std::size_t named = find([&](std::size_t k) {
    return rows[k].is_one_to_one() && body_of(m, chain[k]).joint_name == name;
  });
  if (named < rows.size()) return named;
  const std::size_t direct = find([&](std::size_t k) { return rows[k].is_one_to_one(); });
  return direct < rows.size() ? direct : find([](std::size_t) { return true; });
}

Joint joint_of(const Mechanism& m, const Body& body, const ChainJoint& drive) {
  const Actuator& a = m.actuators()[static_cast<std::size_t>(drive.actuator)];
  Joint joint;
  joint.kind = body.joint == BodyJoint::kRevolute ? JointKind::kRevolute : JointKind::kPrismatic;
  joint.lower = a.lower;
  joint.upper = a.upper;
  joint.max_speed = a.max_speed;
  if (a.max_effort > 0.0) joint.max_effort = a.max_effort;
  if (drive.ratio == 1.0 && drive.offset == 0.0) return joint;
  const double one = drive.ratio * a.lower + drive.offset,
               other = drive.ratio * a.upper + drive.offset;
  const bool is_free = is_no_limit(a.lower, a.upper);
  joint.lower = is_free ? -kNoLimit : std::min(one, other);
  joint.upper = is_free ? kNoLimit : std::max(one, other);
  joint.max_speed *= std::abs(drive.ratio);
  joint.max_effort /= std::abs(drive.ratio);
  return joint;
}

// Whether limits have no information: none were given, or a whole revolution, which descriptions
// use for joints that need no limits.
bool says_nothing(const Body& copy, const CopyLimits& limits) {
  if (limits.lower == 0.0 && limits.upper == 0.0) return true;
  constexpr double kRevolution = 2.0 * kPi * (1.0 - 1e-3);  // written with a few digits
  return copy.joint == BodyJoint::kRevolute && std::abs(limits.upper - limits.lower) >= kRevolution;
}

// Restricts a joint to the limits of its mimic joint.
void keep_within(const Body& copy, const Body& own, const RowDrive& drive, Joint& joint,
                 std::vector<std::string>& notes) {
  if (!copy.copy_limits) return;
  const CopyLimits& limits = *copy.copy_limits;
  if (limits.max_speed > 0.0) {
    const double most = limits.max_speed / std::abs(drive.ratio);
    joint.max_speed = joint.max_speed > 0.0 ? std::min(joint.max_speed, most) : most;
  }
  if (says_nothing(copy, limits)) return;
  const double one = (limits.lower - drive.offset) / drive.ratio,
               other = (limits.upper - drive.offset) / drive.ratio;
  const double lower = std::max(joint.lower, std::min(one, other)),
               upper = std::min(joint.upper, std::max(one, other));
  if (!(lower < upper)) {
    notes.push_back(fmt::format(
        "the limits of joint `{}` leave joint `{}`, which it copies, no range; they do not count",
        copy.joint_name, own.joint_name));
    return;
  }
  constexpr double kRounding = 1e-6;  // of the range
  const bool is_less =
      lower - joint.lower + joint.upper - upper > kRounding * (joint.upper - joint.lower);
  joint.lower = lower;
  joint.upper = upper;
  if (!is_less) return;
  notes.push_back(
      fmt::format("the limits of joint `{}` keep joint `{}`, which it copies, between "
                  "{} and {}",
                  copy.joint_name, own.joint_name, format_joint_value(joint.kind, lower),
                  format_joint_value(joint.kind, upper)));
}

// Stribeck friction depends on the speed of its own joint, so it cannot be transferred to another
// one.
bool has_own_stribeck(const Body& copy, const Body& own) {
  const Friction &a = copy.link.friction, &b = own.link.friction;
  const bool is_dry = a.coulomb_plus != 0.0 || a.coulomb_minus != 0.0;
  return a.stribeck_speed != 0.0 || (is_dry && b.stribeck_speed != 0.0);
}

}  // namespace

Result<ChainDrives> drives_of_chain(const Mechanism& m, const std::vector<int>& chain) {
  std::vector<RowActuator> rows;
  for (const int body : chain) {
    const auto found = actuator_of(m, body);
    if (!found) return refused(m, body);
    rows.push_back(*found);
  }
  ChainDrives result;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::size_t own = own_row(m, chain, rows, rows[k].actuator);
    if (own == k) {
      result.drives.emplace_back();
      result.joints.push_back({.actuator = rows[k].actuator,
                               .row = static_cast<int>(k),
                               .ratio = rows[k].ratio,
                               .offset = rows[k].offset});
      continue;
    }
    const Body &copy = body_of(m, chain[k]), &leader = body_of(m, chain[own]);
    if (has_own_stribeck(copy, leader)) {
      return Error{"coupled",
                   fmt::format("joint `{}` of `{}` copies `{}`, and static friction cannot be that "
                               "of two joints; give it to `{}` alone",
                               copy.joint_name, m.name(), leader.joint_name, leader.joint_name)};
    }
    const double ratio = rows[k].ratio / rows[own].ratio;
    result.drives.push_back({.of = static_cast<int>(own),
                             .ratio = ratio,
                             .offset = rows[k].offset - ratio * rows[own].offset});
  }
  return result;
}

std::vector<Joint> joints_of_chain(const Mechanism& m, const std::vector<int>& chain,
                                   const ChainDrives& drives, std::vector<std::string>& notes) {
  std::vector<Joint> joints(chain.size());
  for (const ChainJoint& drive : drives.joints) {
    const auto k = static_cast<std::size_t>(drive.row);
    joints[k] = joint_of(m, body_of(m, chain[k]), drive);
  }
  for (std::size_t k = 0; k < chain.size(); ++k) joints[k].drive = drives.drives[k];
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const RowDrive& drive = drives.drives[k];
    if (drive.of < 0) continue;
    const Body& copy = body_of(m, chain[k]);
    const auto own = static_cast<std::size_t>(drive.of);
    joints[k].kind =
        copy.joint == BodyJoint::kRevolute ? JointKind::kRevolute : JointKind::kPrismatic;
    keep_within(copy, body_of(m, chain[own]), drive, joints[own], notes);
  }
  return joints;
}

Eigen::VectorXd values_at_zero(const Mechanism& m, const ChainDrives& drives) {
  Eigen::VectorXd values = m.spec().offset;
  for (const ChainJoint& joint : drives.joints) {
    if (joint.offset != 0.0)
      values -= m.spec().coupling.col(joint.actuator) * (joint.offset / joint.ratio);
  }
  return values;
}

void add_copied_motor(const Link& copy, double ratio, Link& leader) {
  // Forces at the joint, as seen at the shaft of the source joint's motor.
  const double gear = std::abs(copy.gear * ratio), shaft = std::abs(leader.gear);
  const double once = gear / shaft, squared = once * once;
  leader.motor_inertia += squared * copy.motor_inertia;
  leader.friction.viscous += squared * copy.friction.viscous;
  const double forwards = ratio > 0.0 ? copy.friction.coulomb_plus : -copy.friction.coulomb_minus,
               backwards = ratio > 0.0 ? copy.friction.coulomb_minus : -copy.friction.coulomb_plus;
  leader.friction.coulomb_plus += once * forwards;
  leader.friction.coulomb_minus += once * backwards;
}

}  // namespace armlet
