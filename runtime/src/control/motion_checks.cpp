#include "armlet/control/motion_checks.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

// Whether a motor would exceed its limit.
bool is_beyond(const MotionForces& forces) {
  constexpr double kRounding = 1e-9;
  return forces.nearest >= 0 &&
         forces.peaks[static_cast<std::size_t>(forces.nearest)].share() > 1.0 + kRounding;
}

template <class Forces>
TorqueReport compared(const Trajectory& motion, TorqueCheck wanted, bool slows,
                      const Forces& forces_of) {
  TorqueReport report{.duration = motion.duration()};
  try {
    MotionForces forces = forces_of();
    if (!is_beyond(forces)) return report;
    if (slows && std::isfinite(forces.slower)) {
      report.slower = forces.slower;
      return report;
    }
    report.forces = std::move(forces);
  } catch (const ArgumentError& error) {
    report.beyond_numbers = error.what();
  }
  report.is_refused = wanted != TorqueCheck::kReport;
  return report;
}

// Whether the tool or its payload presses into an object, which causes a contact force.
bool presses(const Cell& cell, const CellCollision& met) {
  return feels(cell, met.body) && !met.other.object.empty();
}

// Whether a robot started a motion with a number above `last` at t_ns or before.
bool has_started(const Cell& cell, int robot, int last, std::int64_t t_ns) {
  for (int motion = last + 1; motion <= cell.robot(robot).motion_id; ++motion) {
    const MotionReport& report = cell.report(motion);
    if (report.robot == robot) return report.start_ns <= t_ns;
  }
  return false;
}

}  // namespace

TorqueReport check_torques(const Cell& cell, int robot, const Trajectory& motion,
                           TorqueCheck wanted, bool fixed_time) {
  const Robot& arm = *cell.robot(robot).loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(arm) || motion.duration() <= 0.0)
    return {};
  return compared(motion, wanted, wanted == TorqueCheck::kLimit && !fixed_time,
                  [&] { return motion_forces(arm, motion); });
}

TorqueReport check_command_torques(const Cell& cell, int robot, const Trajectory& motion,
                                   double from, double until, TorqueCheck wanted) {
  const Robot& arm = *cell.robot(robot).loaded;
  if (wanted == TorqueCheck::kIgnore || !has_force_limits(arm)) return {};
  return compared(motion, wanted, false, [&] { return command_forces(arm, motion, from, until); });
}

CollisionReport check_collisions(const Cell& cell, int robot, const Trajectory& motion,
                                 const MovePolicies& policies,
                                 std::span<const MotionBeside> beside) {
  CollisionReport report;
  const CollisionCheck wanted = policies.avoid ? CollisionCheck::kError : policies.collisions;
  if (wanted == CollisionCheck::kIgnore || motion.duration() <= 0.0) return report;
  std::vector<CellCollision> met = find_collisions(cell, robot, motion, beside);
  if (policies.touching)
    std::erase_if(met, [](const CellCollision& each) { return !each.other.object.empty(); });
  if (policies.guarded && wanted == CollisionCheck::kError)
    std::erase_if(met, [&](const CellCollision& each) { return presses(cell, each); });
  if (wanted == CollisionCheck::kError) {
    report.is_refused = !met.empty();
    report.certain = std::move(met);
    return report;
  }
  for (CellCollision& each : met) {
    const int other = each.other.robot;
    const bool is_other = other >= 0 && other != robot;
    const bool is_known =
        is_other && std::ranges::find(beside, other, &MotionBeside::robot) != beside.end();
    const bool stands = is_other && !is_known && !cell.is_moving(other);
    if (each.at_start || !(policies.guarded || stands)) {
      report.certain.push_back(std::move(each));
      continue;
    }
    std::optional<int> last;
    if (is_other && !is_known) last = cell.robot(other).motion_id;
    report.possible.push_back({.met = std::move(each), .guarded = policies.guarded, .last = last});
  }
  return report;
}

std::vector<CellCollision> confirmed_collisions(const Cell& cell, int motion,
                                                const std::vector<PossibleCollision>& possible) {
  const MotionReport& report = cell.report(motion);
  const double duration = to_seconds(report.end_ns - report.start_ns);
  std::vector<CellCollision> happened;
  for (const PossibleCollision& each : possible) {
    const CellCollision& met = each.met;
    if (report.state == MotionState::kStopped && met.t >= duration) continue;
    if (each.last && has_started(cell, met.other.robot, *each.last, report.start_ns + to_ns(met.t)))
      continue;
    // A deeper contact is not a touch.
    if (each.guarded && presses(cell, met) &&
        -distance_between(cell, met.body, met.other, Carried::kLeftOut) <= kPressed)
      continue;
    happened.push_back(met);
  }
  return happened;
}

std::vector<LimitViolation> excesses(const Robot& robot, const Trajectory& motion) {
  constexpr double kAtLimit = 1e-9;  // rad or m, the tolerance with which motions are verified
  std::vector<LimitViolation> outside;
  for (int i = 0; i < robot.n(); ++i) {
    const Trajectory::Range range = motion.range(i);
    if (range.upper > robot.upper()[i] + kAtLimit)
      outside.push_back({.joint = i, .value = range.upper, .limit = robot.upper()[i]});
    if (range.lower < robot.lower()[i] - kAtLimit)
      outside.push_back({.joint = i, .value = range.lower, .limit = robot.lower()[i]});
  }
  return outside;
}

const LimitViolation* farthest(const std::vector<LimitViolation>& violations) {
  const auto most = std::ranges::max_element(violations, {}, &LimitViolation::excess);
  return most == violations.end() ? nullptr : &*most;
}

bool starts_and_stops(const Trajectory& motion) {
  for (int i = 0; i < motion.n(); ++i) {
    if (motion.continuity(i, 1e-6) < 1) return false;
  }
  return true;
}

}  // namespace armlet
