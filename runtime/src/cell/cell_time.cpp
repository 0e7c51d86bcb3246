// Advancing time in a cell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "cell/contact_picking.hpp"
#include "cell/way_to_rest.hpp"

namespace armlet {

namespace {

// rad or m, and per s: tolerance for states that were printed and read back.
constexpr double kSamePosition = 1e-6;

void check_start(const CellRobot& arm, const Trajectory& trajectory) {
  check_size("trajectory", trajectory.n(), arm.model->n());
  const double apart = (trajectory.start() - arm.q).cwiseAbs().maxCoeff();
  if (apart > kSamePosition) {
    throw ArgumentError(fmt::format(
        "The motion of \"{}\" starts {} rad or m from where the robot is.", arm.name, apart));
  }
}

}  // namespace

int Cell::start(int index, Trajectory trajectory) {
  const CellRobot& arm = robot(index);
  check_start(arm, trajectory);
  if (arm.motion) throw ArgumentError(fmt::format("\"{}\" is moving already.", arm.name));
  return execute(index, std::move(trajectory), std::nullopt);
}

int Cell::execute(int index, Trajectory trajectory, std::optional<std::int64_t> held_ns) {
  CellRobot& arm = state(index);
  begin();
  settle_contacts();
  if (arm.on >= 0) loosen_grip(index, trajectory);
  arm.motion.emplace(std::move(trajectory), now_ns());
  arm.motion_id = static_cast<int>(reports_.size());
  reports_.push_back(
      {.robot = index, .start_ns = now_ns(), .end_ns = arm.motion->end_ns(), .held_ns = held_ns});
  arm.motion->sample(now_ns(), arm.q, arm.qd, arm.qdd);
  follow_hands();
  publish(index, arm.motion_id);
  return arm.motion_id;
}

bool Cell::can_drive(int index) const {
  if (!is_moving(index)) return true;
  const MotionReport& report = this->report(robot(index).motion_id);
  return report.held_ns && *report.held_ns <= now_ns() && !robot(index).motion->is_stopped();
}

int Cell::drive(int index, Trajectory trajectory, std::optional<std::int64_t> held_ns) {
  CellRobot& arm = state(index);
  check_start(arm, trajectory);
  if (!can_drive(index)) throw ArgumentError(fmt::format("\"{}\" is moving already.", arm.name));
  for (int i = 0; i < trajectory.n(); ++i) {
    const double step = std::abs(trajectory.value(i, 0.0, 1) - arm.qd[i]);
    if (step <= kSamePosition) continue;
    throw ArgumentError(fmt::format("Joint {} of \"{}\" would change its speed by {} at once.",
                                    i + 1, arm.name, step));
  }
  if (arm.motion) {
    MotionReport& former = reports_[static_cast<std::size_t>(arm.motion_id)];
    former.state = MotionState::kReached;
    former.end_ns = now_ns();
    events_.push_back({.t_ns = now_ns(), .robot = index, .motion = arm.motion_id});
  }
  return execute(index, std::move(trajectory), held_ns);
}

int Cell::push(int index, Trajectory piece, const Eigen::VectorXd& forces) {
  check_start(robot(index), piece);
  check_size("forces", forces.size(), robot(index).model->n());
  CellRobot& arm = state(index);
  if (arm.forces.size() == 0) {
    if (arm.motion) throw ArgumentError(fmt::format("\"{}\" is moving already.", arm.name));
    const int motion = execute(index, std::move(piece), std::nullopt);
    arm.forces = forces;
    return motion;
  }
  arm.forces = forces;
  settle_contacts();
  arm.motion.emplace(std::move(piece), now_ns());
  arm.motion->sample(now_ns(), arm.q, arm.qd, arm.qdd);
  reports_[static_cast<std::size_t>(arm.motion_id)].end_ns = arm.motion->end_ns();
  return arm.motion_id;
}

void Cell::settle(int index) {
  if (robot(index).forces.size() != 0) begin_rest(index, false);
}

void Cell::begin_rest(int index, bool stopped) {
  CellRobot& arm = state(index);
  settle_contacts();
  arm.forces.resize(0);
  Trajectory rest = way_to_rest(*arm.model, arm.q, arm.qd, arm.qdd);
  if (stopped) {
    arm.motion = Motion::stopping(std::move(rest), now_ns());
  } else {
    arm.motion.emplace(std::move(rest), now_ns());
  }
  reports_[static_cast<std::size_t>(arm.motion_id)].end_ns = arm.motion->end_ns();
  end_due_motions();  // its robot may have been at rest
}

void Cell::stop(int index) {
  CellRobot& arm = state(index);
  if (!arm.motion) return;
  if (arm.forces.size() != 0) {
    begin_rest(index, true);
    return;
  }
  arm.motion->stop(now_ns(), arm.model->max_accel(), arm.model->max_jerk());
  forget_ahead();
  reports_[static_cast<std::size_t>(arm.motion_id)].end_ns = arm.motion->end_ns();
  end_due_motions();  // its robot may have been at rest
}

void Cell::halt(int index) {
  stop(index);
  if (robot(index).motion) reports_[static_cast<std::size_t>(robot(index).motion_id)].halted = true;
}

const MotionReport& Cell::report(int motion) const {
  if (motion < 0 || motion >= static_cast<int>(reports_.size())) {
    throw ArgumentError(fmt::format("There is no motion {}.", motion));
  }
  return reports_[static_cast<std::size_t>(motion)];
}

std::optional<std::int64_t> Cell::next_event() const {
  std::optional<std::int64_t> next;
  for (const CellRobot& each : robots_) {
    if (each.motion && each.forces.size() == 0)
      next = std::min(next.value_or(each.motion->end_ns()), each.motion->end_ns());
  }
  return next;
}

std::int64_t Cell::next_multiple(std::int64_t period_ns) const {
  return (now_ns() / period_ns + 1) * period_ns;
}

std::int64_t Cell::next_tick() const { return next_multiple(options_.tick_ns); }

void Cell::advance_to(std::int64_t t_ns) {
  if (t_ns > now_ns()) {
    begin();
  } else {
    clock_.advance_to(t_ns);  // throws for the past
  }
  end_due_motions();
  while (now_ns() < t_ns) {
    const auto event = next_event();
    std::int64_t next = std::min(t_ns, event.value_or(t_ns));
    next = std::min(next, look_ahead().value_or(t_ns));
    const std::int64_t sample = next_multiple(options_.sample_period_ns);
    const bool moves =
        std::ranges::any_of(robots_, [](const CellRobot& each) { return each.motion.has_value(); });
    if (moves && (listening() || !trails_.empty())) next = std::min(next, sample);
    const bool due = next == sample;
    clock_.advance_to(next);
    bring_to(next);
    for (int i = 0; due && i < robot_count(); ++i) {
      // A motion that ends at this instant is reported by end_motion, at rest.
      const CellRobot& arm = robot(i);
      const bool goes_on = arm.motion && (arm.motion->end_ns() > next || arm.forces.size() != 0);
      if (goes_on) publish(i, arm.motion_id);
      if (goes_on) trails_.extend(*this, i, false);
    }
    let_happen();
    end_due_motions();
  }
}

std::vector<CellEvent> Cell::take_events() { return std::exchange(events_, {}); }

void Cell::bring_to(std::int64_t t_ns) {
  for (int i = 0; i < robot_count(); ++i) {
    CellRobot& arm = state(i);
    if (!arm.motion) continue;
    arm.motion->sample(t_ns, arm.q, arm.qd, arm.qdd);
    carry_along(i);
  }
  follow_hands();
}

void Cell::end_due_motions() {
  for (int i = 0; i < robot_count(); ++i) {
    const CellRobot& arm = robot(i);
    // A motion under forces continues with another piece.
    if (arm.motion && arm.forces.size() == 0 && arm.motion->end_ns() <= now_ns()) end_motion(i);
  }
}

void Cell::end_motion(int index) {
  CellRobot& arm = state(index);
  MotionReport& report = reports_[static_cast<std::size_t>(arm.motion_id)];
  report.state = arm.motion->is_stopped() ? MotionState::kStopped : MotionState::kReached;
  settle_contacts();
  arm.motion->sample(now_ns(), arm.q, arm.qd, arm.qdd);
  follow_hands();
  arm.motion.reset();
  carry_along(index);
  publish(index, arm.motion_id);
  trails_.extend(*this, index, true);
  events_.push_back({.t_ns = now_ns(), .robot = index, .motion = arm.motion_id});
  if (const int carrier = arm.on >= 0 ? arm.on : index; hand_on(carrier) >= 0) review_grip(carrier);
  if (!options_.contact_picking || arm.on >= 0) return;
  if (auto event = pick_or_put_down(*this, index)) events_.push_back(*std::move(event));
}

}  // namespace armlet
