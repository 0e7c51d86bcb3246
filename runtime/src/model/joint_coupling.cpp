#include "armlet/model/joint_coupling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/format.hpp"

namespace armlet {
namespace {

// The joint that moves each row, from 0.
std::vector<int> joints_of(const std::vector<Joint>& rows) {
  std::vector<int> joint_of(rows.size(), -1);
  int n = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].drive.of < 0) joint_of[k] = n++;
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].drive.of >= 0) joint_of[k] = joint_of[static_cast<std::size_t>(rows[k].drive.of)];
  }
  return joint_of;
}

JointMatrix factors_of(const RobotSpec& spec) {
  const std::vector<int> joint_of = joints_of(spec.joints);
  JointMatrix E = JointMatrix::Zero(static_cast<Eigen::Index>(joint_of.size()), spec.home.size());
  for (std::size_t k = 0; k < joint_of.size(); ++k)
    E(static_cast<Eigen::Index>(k), joint_of[k]) = spec.joints[k].drive.ratio;
  return E;
}

JointVector offsets_of(const RobotSpec& spec) {
  JointVector offset(static_cast<Eigen::Index>(spec.joints.size()));
  for (std::size_t k = 0; k < spec.joints.size(); ++k)
    offset[static_cast<Eigen::Index>(k)] = spec.joints[k].drive.offset;
  return offset;
}

RobotSpec spec_of_rows(RobotSpec spec, JointsIn home) {
  for (Joint& row : spec.joints) row.drive = {};
  spec.followers = nullptr;
  spec.home = home;
  // Limits are products as well, and may differ by rounding.
  for (Eigen::Index k = 0; k < home.size(); ++k) {
    const Joint& row = spec.joints[static_cast<std::size_t>(k)];
    spec.home[k] = std::clamp(home[k], row.lower, row.upper);
  }
  return spec;
}

}  // namespace

JointCoupling::JointCoupling(const RobotSpec& spec)
    : E(factors_of(spec)),
      offset(offsets_of(spec)),
      rows(spec_of_rows(spec, E * spec.home + offset)) {}

RowMotion motion_of_row(const Robot& robot, int k) {
  const JointCoupling* coupling = robot.coupling();
  if (coupling == nullptr) return {.joint = k};
  RowMotion motion;
  while (coupling->E(k, motion.joint) == 0.0) ++motion.joint;
  motion.ratio = coupling->E(k, motion.joint);
  return motion;
}

JointVector row_values(const Robot& robot, JointsIn q) {
  const JointCoupling* coupling = robot.coupling();
  return coupling == nullptr ? JointVector(q) : coupling->values(q);
}

JointVector row_rates(const Robot& robot, JointsIn qd) {
  const JointCoupling* coupling = robot.coupling();
  return coupling == nullptr ? JointVector(qd) : coupling->rates(qd);
}

JointVector joint_forces(const Robot& robot, JointsIn of_rows) {
  const JointCoupling* coupling = robot.coupling();
  if (coupling == nullptr) return of_rows;
  return coupling->E.transpose() * of_rows;
}

std::string copy_text(const Robot& robot, int k) {
  if (robot.coupling() == nullptr) return {};
  const RowDrive& drive = robot.row(k).drive;
  if (drive.of < 0) return {};
  const int joint = motion_of_row(robot, k).joint;
  const JointKind kind = robot.row(k).kind, other = robot.joint(joint).kind;
  std::string text = format_number(drive.ratio, 6);
  if (kind != other) text += kind == JointKind::kRevolute ? " rad/m" : " m/rad";
  text += fmt::format(" x joint {}", joint + 1);
  if (drive.offset == 0.0) return text;
  return text + (drive.offset < 0.0 ? " - " : " + ") +
         format_joint_value(kind, std::abs(drive.offset));
}

}  // namespace armlet
