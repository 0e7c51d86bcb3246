#include "validate.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

[[noreturn]] void fail(const RobotSpec& spec, std::string_view part, std::size_t i,
                       const std::string& what) {
  throw ArgumentError(fmt::format("{} {} of robot `{}` {}.", part, i + 1, spec.name, what));
}

void check_joint(const RobotSpec& spec, std::size_t i) {
  const Joint& joint = spec.joints[i];
  const std::pair<const char*, double> numbers[] = {{"theta", joint.dh.theta},
                                                    {"d", joint.dh.d},
                                                    {"a", joint.dh.a},
                                                    {"alpha", joint.dh.alpha},
                                                    {"lower limit", joint.lower},
                                                    {"upper limit", joint.upper},
                                                    {"maxSpeed", joint.max_speed},
                                                    {"maxAccel", joint.max_accel},
                                                    {"maxJerk", joint.max_jerk}};
  for (const auto& [name, value] : numbers) {
    if (!std::isfinite(value)) {
      fail(spec, "Joint", i,
           fmt::format("has {} = {}; expected a finite number", name, format_number(value, 6)));
    }
  }
  if (joint.lower > joint.upper) {
    fail(spec, "Joint", i,
         fmt::format("has its limits swapped: {} is above {}",
                     format_joint_value(joint.kind, joint.lower),
                     format_joint_value(joint.kind, joint.upper)));
  }
  const std::pair<const char*, double> rates[] = {
      {"maxSpeed", joint.max_speed}, {"maxAccel", joint.max_accel}, {"maxJerk", joint.max_jerk}};
  for (const auto& [name, value] : rates) {
    if (value < 0.0) {
      fail(spec, "Joint", i, fmt::format("has {} = {}; it must be above zero", name, value));
    }
  }
  if (!(joint.max_effort > 0.0)) {
    fail(spec, "Joint", i,
         fmt::format("has maxTorque = {}; it must be above zero", joint.max_effort));
  }
}

// Principal moments of a rigid body are not negative and none exceeds the sum of the other two.
std::string inertia_fault(const Eigen::Matrix3d& inertia, InertiaCheck check) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  const double tolerance = 1e-9 * scale;
  Eigen::Index i = 0, j = 0;
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff(&i, &j) > tolerance) {
    return fmt::format(
        "has an inertia that is not symmetric: its element [{}, {}] is {} and [{}, {}] "
        "is {}",
        i, j, format_number(inertia(i, j), 6), j, i, format_number(inertia(j, i), 6));
  }
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  if (!moments.allFinite()) return "has an inertia whose principal moments are not finite";
  if (moments[0] < -tolerance) {
    return fmt::format("has an inertia with the negative principal moment {:.4g} kg m^2",
                       moments[0]);
  }
  if (check == InertiaCheck::kRigidBody &&
      moments[2] > (moments[0] + moments[1]) * (1.0 + 1e-9) + tolerance) {
    return fmt::format(
        "has principal moments {:.4g}, {:.4g}, {:.4g} kg m^2; in a rigid body none exceeds the sum "
        "of the other two",
        moments[0], moments[1], moments[2]);
  }
  return {};
}

// Static friction is at least as large as sliding friction.
std::string stribeck_fault(const Friction& friction) {
  if (friction.stribeck_speed == 0.0) {
    if (friction.static_torque == 0.0) return {};
    return fmt::format("has the static friction {} without a Stribeck speed above zero",
                       friction.static_torque);
  }
  const double coulomb = std::max(friction.coulomb_plus, -friction.coulomb_minus);
  if (friction.static_torque >= coulomb) return {};
  return fmt::format(
      "has the static friction {} below its Coulomb friction {}; a joint sticks at least as firmly "
      "as it slides",
      friction.static_torque, coulomb);
}

}  // namespace

std::string link_fault(const Link& link, InertiaCheck check) {
  const std::pair<const char*, double> numbers[] = {
      {"mass", link.mass},
      {"motorInertia", link.motor_inertia},
      {"gear", link.gear},
      {"viscous friction", link.friction.viscous},
      {"positive Coulomb friction", link.friction.coulomb_plus},
      {"negative Coulomb friction", link.friction.coulomb_minus},
      {"static friction", link.friction.static_torque},
      {"Stribeck speed", link.friction.stribeck_speed}};
  for (const auto& [name, value] : numbers) {
    if (!std::isfinite(value)) {
      return fmt::format("has {} = {}; expected a finite number", name, format_number(value, 6));
    }
  }
  if (!link.com.allFinite() || !link.inertia.allFinite()) {
    return "has a centre of mass or an inertia that is not finite";
  }
  const std::pair<const char*, double> not_negative[] = {
      {"mass", link.mass},
      {"motorInertia", link.motor_inertia},
      {"viscous friction", link.friction.viscous},
      {"positive Coulomb friction", link.friction.coulomb_plus},
      {"static friction", link.friction.static_torque},
      {"Stribeck speed", link.friction.stribeck_speed}};
  for (const auto& [name, value] : not_negative) {
    if (value < 0.0) {
      return fmt::format("has {} = {}; it must be zero or more", name, value);
    }
  }
  if (link.friction.coulomb_minus > 0.0) {
    return fmt::format("has the Coulomb friction {} for negative speed; it must be zero or less",
                       link.friction.coulomb_minus);
  }
  if (const std::string fault = stribeck_fault(link.friction); !fault.empty()) return fault;
  return inertia_fault(link.inertia, check);
}

void check_joints(const RobotSpec& spec) {
  const std::size_t n = spec.joints.size();
  if (n == 0) {
    throw ArgumentError(
        fmt::format("Robot `{}` has no joints; expected 1 to {}.", spec.name, kMaxJoints));
  }
  if (n > static_cast<std::size_t>(kMaxJoints)) {
    throw ArgumentError(
        fmt::format("Robot `{}` has {} joints; expected 1 to {}.", spec.name, n, kMaxJoints));
  }
  for (std::size_t i = 0; i < n; ++i) check_joint(spec, i);
}

void check_links(const RobotSpec& spec) {
  if (spec.links.size() != spec.joints.size()) {
    throw ArgumentError(fmt::format("Robot `{}` has {} links for {} joints; expected one each.",
                                    spec.name, spec.links.size(), spec.joints.size()));
  }
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    const std::string fault = link_fault(spec.links[i], spec.inertia_check);
    if (!fault.empty()) fail(spec, "Link", i, fault);
  }
}

void check_drives(const RobotSpec& spec) {
  const int n = static_cast<int>(spec.joints.size());
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    const RowDrive& drive = spec.joints[i].drive;
    if (drive.of < 0) continue;
    if (drive.of >= n || spec.joints[static_cast<std::size_t>(drive.of)].drive.of >= 0) {
      fail(spec, "Row", i,
           fmt::format("copies row {}; expected one with a joint of its own", drive.of + 1));
    }
    if (!std::isfinite(drive.ratio) || drive.ratio == 0.0 || !std::isfinite(drive.offset)) {
      fail(
          spec, "Row", i,
          fmt::format("copies row {} times {} plus {}; expected finite numbers, the first not zero",
                      drive.of + 1, drive.ratio, drive.offset));
    }
    const Link& link = spec.links[i];
    const Friction& f = link.friction;
    if (link.motor_inertia != 0.0 || f.viscous != 0.0 || f.coulomb_plus != 0.0 ||
        f.coulomb_minus != 0.0 || f.stribeck_speed != 0.0) {
      fail(spec, "Row", i,
           fmt::format("copies row {}, which has the motor; give that one the rotor inertia and "
                       "the friction",
                       drive.of + 1));
    }
  }
}

void check_payload(const RobotSpec& spec) {
  Link body;
  body.mass = spec.payload.mass;
  body.com = spec.payload.com;
  body.inertia = spec.payload.inertia;
  const std::string fault = link_fault(body, InertiaCheck::kRigidBody);
  if (fault.empty()) return;
  throw ArgumentError(fmt::format("The payload of robot `{}` {}.", spec.name, fault));
}

void check_home(const RobotSpec& spec, std::span<const int> rows) {
  check_size(spec.name + ".home", spec.home.size(), static_cast<Eigen::Index>(rows.size()));
  check_finite(spec.name + ".home", spec.home);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Joint& joint = spec.joints[static_cast<std::size_t>(rows[i])];
    const double q = spec.home[static_cast<Eigen::Index>(i)];
    if (q >= joint.lower && q <= joint.upper) continue;
    fail(spec, "Joint", i,
         fmt::format("is at {} in the home position; its range is {} to {}",
                     format_joint_value(joint.kind, q, q < joint.lower ? joint.lower : joint.upper),
                     format_joint_value(joint.kind, joint.lower),
                     format_joint_value(joint.kind, joint.upper)));
  }
}

void check_link_pairs(const RobotSpec& spec) {
  const int n = static_cast<int>(spec.joints.size());
  for (const auto* pairs : {&spec.allow, &spec.watch}) {
    for (const auto& [first, second] : *pairs) {
      if (first > second && second >= 0 && first <= n) continue;
      throw ArgumentError(
          fmt::format("Links {} and {} are no pair of robot `{}`; expected two of 0 (its base) to "
                      "{}, the larger first.",
                      first, second, spec.name, n));
    }
  }
}

}  // namespace armlet
