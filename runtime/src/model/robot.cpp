#include "armlet/model/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "armlet/model/joint_limits.hpp"
#include "validate.hpp"

namespace armlet {
namespace {

void fill_default_rates(Joint& joint) {
  const double speed = joint.is_revolute() ? kDefaultRevoluteSpeed : kDefaultPrismaticSpeed;
  if (joint.max_speed == 0.0) joint.max_speed = speed;
  if (joint.max_accel == 0.0) joint.max_accel = joint.max_speed / kDefaultTimeToSpeed;
  if (joint.max_jerk == 0.0) joint.max_jerk = joint.max_accel / kDefaultTimeToAccel;
}

// Limits and rates of a mimic joint: those of its source joint times the ratio.
void follow(const Joint& joint, const RowDrive& drive, Joint& row) {
  const double one = drive.ratio * joint.lower + drive.offset,
               other = drive.ratio * joint.upper + drive.offset;
  const bool is_free = row.is_revolute() && is_no_limit(joint.lower, joint.upper);
  row.lower = is_free ? -kNoLimit : std::min(one, other);
  row.upper = is_free ? kNoLimit : std::max(one, other);
  row.max_speed = std::abs(drive.ratio) * joint.max_speed;
  row.max_accel = std::abs(drive.ratio) * joint.max_accel;
  row.max_jerk = std::abs(drive.ratio) * joint.max_jerk;
  row.max_effort = std::numeric_limits<double>::infinity();
}

bool copies(const Joint& row) { return row.drive.of >= 0; }

// Sets the rows of mimic joints; the source of a mimic joint must not be one itself.
void follow_drives(RobotSpec& spec) {
  for (Joint& row : spec.joints) {
    if (copies(row)) follow(spec.joints[static_cast<std::size_t>(row.drive.of)], row.drive, row);
  }
}

Chain make_chain(const RobotSpec& spec) {
  Chain chain;
  chain.coupled = std::ranges::any_of(spec.joints, copies);
  chain.n = static_cast<int>(spec.joints.size());
  chain.standard = spec.convention == DhConvention::kStandard;
  chain.T_world_base = spec.T_world_base * spec.T_base_first;
  chain.T_flange_tool = spec.T_flange_tool;
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    const Joint& joint = spec.joints[i];
    const std::size_t x = chain.standard ? i + 1 : i;
    const SinCos alpha = snapped_sin_cos(joint.dh.alpha);
    chain.a[x] = joint.dh.a;
    chain.sin_alpha[x] = alpha.sin;
    chain.cos_alpha[x] = alpha.cos;
    chain.revolute[i] = joint.is_revolute();
    chain.theta[i] = joint.dh.theta;
    chain.d[i] = joint.dh.d;
    chain.q_to_theta[i] = joint.is_revolute() ? 1.0 : 0.0;
    chain.q_to_d[i] = 1.0 - chain.q_to_theta[i];
  }
  // A chain of DH rows has one link twist more than joints: the one at its unused end is zero.
  chain.cos_alpha[chain.standard ? 0 : spec.joints.size()] = 1.0;
  return chain;
}

template <class Numbers>
bool has_same_bits(const Numbers& a, const Numbers& b) {
  return std::memcmp(a.data(), b.data(), sizeof(*a.data()) * static_cast<std::size_t>(a.size())) ==
         0;
}

// Equality to the last bit, with 0 and -0 different, so that values derived from one have the same
// bits for the other.
bool is_same_chain(const Chain& a, const Chain& b) {
  return a.n == b.n && a.standard == b.standard && a.coupled == b.coupled &&
         a.revolute == b.revolute && has_same_bits(a.theta, b.theta) && has_same_bits(a.d, b.d) &&
         has_same_bits(a.q_to_theta, b.q_to_theta) && has_same_bits(a.q_to_d, b.q_to_d) &&
         has_same_bits(a.a, b.a) && has_same_bits(a.sin_alpha, b.sin_alpha) &&
         has_same_bits(a.cos_alpha, b.cos_alpha) &&
         has_same_bits(a.T_world_base.matrix(), b.T_world_base.matrix()) &&
         has_same_bits(a.T_flange_tool.matrix(), b.T_flange_tool.matrix());
}

// Largest distance by which one row can move the next frame, within the limits.
double row_reach(const Joint& joint) {
  double d = std::abs(joint.dh.d);
  if (!joint.is_revolute()) {
    d = std::max(std::abs(joint.dh.d + joint.lower), std::abs(joint.dh.d + joint.upper));
  }
  return det::hypot(joint.dh.a, d);
}

template <class Member>
Eigen::VectorXd gather(const Robot& robot, Member member) {
  Eigen::VectorXd values(robot.n());
  for (int i = 0; i < robot.n(); ++i) values[i] = robot.joint(i).*member;
  return values;
}

}  // namespace

Robot::Robot(RobotSpec spec) : spec_(std::move(spec)) {
  check_joints(spec_);
  for (Joint& joint : spec_.joints) fill_default_rates(joint);
  if (spec_.links.empty()) spec_.links.resize(spec_.joints.size());
  check_links(spec_);
  check_drives(spec_);
  follow_drives(spec_);
  for (std::size_t k = 0; k < spec_.joints.size(); ++k) {
    if (!copies(spec_.joints[k])) row_of_[static_cast<std::size_t>(n_++)] = static_cast<int>(k);
  }
  check_pose(spec_.name + ".base", spec_.T_world_base);
  check_pose(spec_.name + ".first joint", spec_.T_base_first);
  check_pose(spec_.name + ".tool", spec_.T_flange_tool);
  check_finite(spec_.name + ".gravity", spec_.gravity);
  check_payload(spec_);
  check_link_pairs(spec_);

  lower_ = gather(*this, &Joint::lower);
  upper_ = gather(*this, &Joint::upper);
  max_speed_ = gather(*this, &Joint::max_speed);
  max_accel_ = gather(*this, &Joint::max_accel);
  max_jerk_ = gather(*this, &Joint::max_jerk);
  chain_ = make_chain(spec_);
  walk_plan_ = plan_walk(chain_);

  if (spec_.home.size() == 0) {
    spec_.home = Eigen::VectorXd::Zero(n()).cwiseMax(lower_).cwiseMin(upper_);
  }
  check_home(spec_, std::span(row_of_).first(static_cast<std::size_t>(n_)));
  if (chain_.coupled) coupling_ = std::make_shared<const JointCoupling>(spec_);

  reach_ = spec_.T_flange_tool.translation().norm();
  for (const Joint& joint : spec_.joints) {
    length_ += std::abs(joint.dh.a) + std::abs(joint.dh.d);
    reach_ += row_reach(joint);
  }
  length_ = std::max(length_, 0.1);
}

Robot Robot::changed(RobotSpec spec) const {
  Robot copy(std::move(spec));
  if (is_same_chain(copy.chain_, chain_)) copy.from_chain_ = from_chain_;
  return copy;
}

Robot Robot::changed_beside_shape(RobotSpec spec) const {
  Robot copy = changed(std::move(spec));
  copy.from_shape_ = from_shape_;
  return copy;
}

const Robot& Robot::uncoupled() const { return coupling_ ? coupling_->rows : *this; }

bool Robot::has_shapes() const {
  return spec_.base.has_shape() || std::ranges::any_of(spec_.links, &Link::has_shape);
}

Robot Robot::with_name(std::string name) const {
  RobotSpec spec = spec_;
  spec.name = std::move(name);
  return changed_beside_shape(std::move(spec));
}

Robot Robot::with_base(const Eigen::Isometry3d& T_world_base) const {
  RobotSpec spec = spec_;
  spec.T_world_base = T_world_base;
  return changed(std::move(spec));
}

Robot Robot::with_tool(const Tool& tool) const {
  RobotSpec spec = spec_;
  spec.tool = tool;
  spec.T_flange_tool = make_translation({0.0, 0.0, tool.length});
  return changed(std::move(spec));
}

Robot Robot::with_tool_point(const Eigen::Isometry3d& T_flange_tool) const {
  RobotSpec spec = spec_;
  spec.T_flange_tool = T_flange_tool;
  return changed(std::move(spec));
}

Robot Robot::with_home(const Eigen::VectorXd& home) const {
  RobotSpec spec = spec_;
  spec.home = home;
  return changed(std::move(spec));
}

Robot Robot::with_payload(const Payload& payload) const {
  RobotSpec spec = spec_;
  spec.payload = payload;
  return changed_beside_shape(std::move(spec));
}

Robot Robot::with_link(int i, const Link& link) const {
  if (i < 0 || i >= rows()) {
    throw ArgumentError(
        fmt::format("There is no link {} in robot `{}`; expected 1 to {}.", i + 1, name(), rows()));
  }
  RobotSpec spec = spec_;
  spec.links[static_cast<std::size_t>(i)] = link;
  return changed(std::move(spec));
}

Robot Robot::with_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) const {
  check_size("lower", lower.size(), n());
  check_size("upper", upper.size(), n());
  RobotSpec spec = spec_;
  for (int i = 0; i < n(); ++i) {
    Joint& joint = spec.joints[static_cast<std::size_t>(row_of(i))];
    joint.lower = lower[i];
    joint.upper = upper[i];
  }
  spec.home = spec.home.cwiseMax(lower).cwiseMin(upper);
  return changed(std::move(spec));
}

Robot Robot::with_acceleration(double fraction) const {
  if (!(fraction > 0.0 && fraction <= 1.0)) {
    throw ArgumentError(fmt::format(
        "The acceleration is {}; expected a fraction of the joint limits, above 0 and at most 1.",
        fraction));
  }
  RobotSpec spec = spec_;
  for (Joint& joint : spec.joints) joint.max_accel *= fraction;
  return changed_beside_shape(std::move(spec));
}

std::vector<Joint> joints_from_table(const std::vector<std::vector<double>>& rows,
                                     std::string_view kinds) {
  if (kinds.size() != rows.size()) {
    throw ArgumentError(
        fmt::format("The table has {} rows, but the joint kinds \"{}\" name {} joints; expected "
                    "one letter R or "
                    "P per row.",
                    rows.size(), kinds, kinds.size()));
  }
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 4) {
      throw ArgumentError(
          fmt::format("Row {} of the table has {} numbers; expected 4: theta, d, a, alpha.", i + 1,
                      rows[i].size()));
    }
    const bool slides = kinds[i] == 'P' || kinds[i] == 'p';
    Joint joint = joint_without_limits(slides ? JointKind::kPrismatic : JointKind::kRevolute);
    joint.dh = {rows[i][0], rows[i][1], rows[i][2], rows[i][3]};
    if (!slides && kinds[i] != 'R' && kinds[i] != 'r') {
      throw ArgumentError(fmt::format(
          "Joint {} has the kind '{}'; expected R for a turning joint or P for a sliding one.",
          i + 1, kinds[i]));
    }
    joints.push_back(joint);
  }
  return joints;
}

}  // namespace armlet
