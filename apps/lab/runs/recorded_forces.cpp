// The motor forces in the record of a run.
//
// Pages interpolate linearly between two rows. Where forces jump, because a motion begins or ends
// or a load changes, the row before is repeated at that instant.

#include <algorithm>
#include <array>
#include <utility>

#include "armlet/cell/clock.hpp"
#include "armlet/core/error.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

bool has_masses(const Robot& robot) { return !robot.spec().links.empty(); }

std::vector<double> row_of(double t, const Eigen::VectorXd& forces) {
  std::vector<double> row{t};
  row.insert(row.end(), forces.begin(), forces.end());
  return row;
}

// Forces that are not finite, from masses or speeds near the limit of doubles, have no row.
std::vector<double> forces_row(double t, const Cell& cell, int robot, std::span<const double> q,
                               std::span<const double> qd, std::span<const double> qdd) {
  const CellRobot& arm = cell.robot(robot);
  const auto joints = [](std::span<const double> values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  };
  if (arm.forces.size() != 0) return row_of(t, arm.forces);
  try {
    return row_of(t, inverse_dynamics(*arm.loaded, joints(q), joints(qd), joints(qdd)) -
                         cell.contact_forces(robot));
  } catch (const ArgumentError&) {
    return {};
  }
}

}  // namespace

void Recording::take_forces(const JointSample& sample) {
  const Host* host = session_ == nullptr ? nullptr : session_->host();
  if (host == nullptr || sample.robot >= host->cell().robot_count()) return;
  const CellRobot& arm = host->cell().robot(sample.robot);
  if (!has_masses(*arm.loaded)) return;
  Forces& known = forces_[static_cast<std::size_t>(sample.robot)];
  const bool has_begun = known.loaded != nullptr;
  known.loaded = sample.motion < 0 ? arm.loaded : nullptr;
  add_forces(sample.robot,
             forces_row(to_seconds(sample.t_ns), host->cell(), sample.robot, sample.q, sample.qd,
                        sample.qdd),
             has_begun);
}

// Adds forces of robots at rest, if they moved or had another payload before.
void Recording::take_forces_at_rest(double t) {
  const Host* host = session_->host();
  const int count = std::min(host->cell().robot_count(), static_cast<int>(forces_.size()));
  for (int i = 0; i < count; ++i) {
    const CellRobot& arm = host->cell().robot(i);
    Forces& known = forces_[static_cast<std::size_t>(i)];
    if (arm.motion || known.loaded == arm.loaded || !has_masses(*arm.loaded)) continue;
    known.loaded = arm.loaded;
    const std::vector<double> q(arm.q.begin(), arm.q.end());
    const std::vector<double> zero(q.size());
    add_forces(i, forces_row(t, host->cell(), i, q, zero, zero), true);
  }
}

// Pages interpolate linearly between two rows: a row of zeros precedes and follows each contact.
void Recording::take_contacts(int robot, double t) {
  const Host* host = session_ == nullptr ? nullptr : session_->host();
  if (host == nullptr || robot >= host->cell().robot_count() || host->cell().robot(robot).on >= 0)
    return;
  const Vector6d wrench = host->cell().contact_wrench(robot);
  Touch& last = touches_[static_cast<std::size_t>(robot)];
  Rows& rows = record_.contact_rows[static_cast<std::size_t>(robot)];
  const bool is_touching = wrench.allFinite() && !wrench.isZero(0.0);
  const auto add = [&](double at, const Vector6d& value) {
    std::array<double, 7> row{at};
    std::ranges::copy(value, row.begin() + 1);
    rows.add(row, true);
  };
  if (is_touching && !last.is_touching) add(last.t, Vector6d::Zero());
  if (is_touching || last.is_touching) add(t, is_touching ? wrench : Vector6d::Zero());
  last = {.t = t, .is_touching = is_touching};
}

void Recording::add_forces(int robot, std::span<const double> row, bool is_break) {
  if (row.empty()) return;
  Rows& rows = record_.force_rows[static_cast<std::size_t>(robot)];
  std::vector<double>& last = forces_[static_cast<std::size_t>(robot)].last_row;
  if (is_break && !last.empty()) {
    last[0] = row[0];
    rows.add(last, true);
  }
  rows.add(row, is_break);
  last.assign(row.begin(), row.end());
}

}  // namespace armlet::lab
