#include "armlet/model/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "validate.hpp"

namespace armlet {
namespace {

[[noreturn]] void fail(const MechanismSpec& spec, std::size_t body, const std::string& what) {
  throw ArgumentError(
      fmt::format("Link `{}` of `{}` {}.", spec.bodies[body].name, spec.name, what));
}

void check_joint_pose(const MechanismSpec& spec, std::size_t i) {
  const Body& body = spec.bodies[i];
  const int parent = body.parent;
  if (parent == static_cast<int>(i)) fail(spec, i, "is its own parent");
  if (parent < -1 || parent >= static_cast<int>(spec.bodies.size())) {
    fail(spec, i, fmt::format("has the parent number {}, which is no link", parent));
  }
  if (parent > static_cast<int>(i)) {
    fail(spec, i,
         fmt::format("hangs on `{}`, which comes after it; a parent comes first",
                     spec.bodies[static_cast<std::size_t>(parent)].name));
  }
  for (std::size_t k = 0; k < i; ++k) {
    if (spec.bodies[k].name == body.name) fail(spec, i, "has the name of another link");
  }
  if (body.name == spec.base_name) fail(spec, i, "has the name of the base");
}

void check_joint_geometry(MechanismSpec& spec, std::size_t i) {
  Body& body = spec.bodies[i];
  if (!body.T_parent_joint.matrix().allFinite()) fail(spec, i, "has a place that is not finite");
  if (!is_rotation(body.T_parent_joint.linear(), 1e-6)) {
    fail(spec, i, "has an orientation that is not a rotation");
  }
  if (body.joint == BodyJoint::kFixed) return;
  const double length = body.axis.norm();
  if (!std::isfinite(length) || length < 1e-9) {
    fail(spec, i,
         fmt::format("has a joint with the axis {}, which has no direction",
                     format_vector(body.axis, 6)));
  }
  // A vector of length 1 is not divided, so a basis vector stays exact.
  if (length != 1.0) body.axis /= length;
}

void check_actuator(const MechanismSpec& spec, const Actuator& actuator) {
  const auto refuse = [&](const std::string& what) {
    throw ArgumentError(fmt::format("Actuator `{}` of `{}` {}.", actuator.name, spec.name, what));
  };
  const std::pair<const char*, double> numbers[] = {{"lower limit", actuator.lower},
                                                    {"upper limit", actuator.upper},
                                                    {"speed limit", actuator.max_speed},
                                                    {"effort limit", actuator.max_effort}};
  for (const auto& [what, value] : numbers) {
    if (!std::isfinite(value)) {
      refuse(fmt::format("has the {} {}; expected a finite number", what, format_number(value, 6)));
    }
  }
  if (actuator.lower > actuator.upper) {
    refuse(fmt::format("has its limits swapped: {} is above {}", actuator.lower, actuator.upper));
  }
  if (actuator.max_speed < 0.0 || actuator.max_effort < 0.0) {
    refuse("has a speed or effort limit below zero");
  }
}

void check_coupling(const MechanismSpec& spec, std::size_t joints) {
  const auto rows = static_cast<Eigen::Index>(joints);
  const auto columns = static_cast<Eigen::Index>(spec.actuators.size());
  if (spec.coupling.rows() != rows || spec.coupling.cols() != columns ||
      spec.offset.size() != rows) {
    throw ArgumentError(
        fmt::format("The coupling of `{}` is {} x {} with {} offsets; expected {} x {} with {}: "
                    "one row for each joint, one "
                    "column for each actuator.",
                    spec.name, spec.coupling.rows(), spec.coupling.cols(), spec.offset.size(), rows,
                    columns, rows));
  }
  check_finite(spec.name + ".coupling", spec.coupling);
  check_finite(spec.name + ".offset", spec.offset);
}

}  // namespace

Mechanism::Mechanism(MechanismSpec spec) : spec_(std::move(spec)) {
  if (spec_.bodies.empty() || spec_.bodies.size() > kMaxBodies) {
    throw ArgumentError(
        fmt::format("Mechanism `{}` has {} links besides its base; expected 1 to {}.", spec_.name,
                    spec_.bodies.size(), kMaxBodies));
  }
  joint_of_.assign(spec_.bodies.size(), -1);
  for (std::size_t i = 0; i < spec_.bodies.size(); ++i) {
    check_joint_pose(spec_, i);
    check_joint_geometry(spec_, i);
    if (const std::string fault = link_fault(spec_.bodies[i].link, spec_.inertia_check);
        !fault.empty()) {
      fail(spec_, i, fault);
    }
    if (spec_.bodies[i].joint == BodyJoint::kFixed) continue;
    joint_of_[i] = static_cast<int>(moving_.size());
    moving_.push_back(static_cast<int>(i));
  }
  if (spec_.coupling.size() == 0 && spec_.offset.size() == 0) {
    const auto n = static_cast<Eigen::Index>(moving_.size());
    spec_.coupling = Eigen::MatrixXd::Identity(n, n);
    spec_.offset = Eigen::VectorXd::Zero(n);
  }
  check_coupling(spec_, moving_.size());
  for (const Actuator& actuator : spec_.actuators) check_actuator(spec_, actuator);
  for (const Tip& tip : spec_.tips) {
    if (tip.body < -1 || tip.body >= static_cast<int>(spec_.bodies.size())) {
      throw ArgumentError(
          fmt::format("Tip `{}` of `{}` is on link number {}, which does not exist.", tip.name,
                      spec_.name, tip.body));
    }
    check_pose(spec_.name + "." + tip.name, tip.T_body_tip);
  }
}

Eigen::VectorXd Mechanism::joint_values(const Eigen::Ref<const Eigen::VectorXd>& q) const {
  check_size("q", q.size(), actuator_count());
  // Added in order, so that the result does not depend on how a library would sum.
  Eigen::VectorXd values = spec_.offset;
  for (Eigen::Index a = 0; a < q.size(); ++a) {
    for (Eigen::Index j = 0; j < values.size(); ++j) values[j] += spec_.coupling(j, a) * q[a];
  }
  return values;
}

int Mechanism::body(std::string_view name) const {
  for (std::size_t i = 0; i < spec_.bodies.size(); ++i) {
    if (spec_.bodies[i].name == name) return static_cast<int>(i);
  }
  throw ArgumentError(fmt::format("`{}` has no link `{}`.", spec_.name, name));
}

const Tip& Mechanism::tip(std::string_view name) const {
  for (const Tip& tip : spec_.tips) {
    if (tip.name == name) return tip;
  }
  throw ArgumentError(fmt::format("`{}` has no tip `{}`.", spec_.name, name));
}

}  // namespace armlet
