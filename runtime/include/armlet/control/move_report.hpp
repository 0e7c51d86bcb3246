// What a move has become: the motion, what the checks found, or why it was refused.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/control/motion_checks.hpp"
#include "armlet/control/refusals.hpp"

namespace armlet {

// The joint that exceeds its limit most, from 0, and by how much, rad or m. -1: no joint does.
struct LimitExcess {
  int joint = -1;
  double by = 0.0;
};

// The planned motion.
//
// model            the robot with the tool point and the limits of this move.
// length           of the path of the tool point, m.
// deviation, turn  largest deviation of the tool from its line, m and rad.
// times            at which the motion reaches or passes each target of several, s.
// missed           distance at which it passes each of them, m; empty: it passes through all.
// T_world_targets  poses of the tool at these targets.
struct PlannedMove {
  std::shared_ptr<const Robot> model{};
  std::optional<Trajectory> motion{};
  double length = 0.0;
  double deviation = 0.0;
  double turn = 0.0;
  std::vector<double> times{};
  std::vector<double> missed{};
  std::vector<Eigen::Isometry3d> T_world_targets{};
};

// What the policies have changed or allowed.
//
// clamped     joint values of the target that were moved to their limits.
// lengthened  the time was too short: the motion takes the least time instead. One for the straight
//             motion, another one for the motion around obstacles that replaces it.
// too_fast    the same where the time was kept.
// beyond      joint values of the motion outside the limits of the robot.
// excess      the largest of `beyond`, or of `clamped`.
struct LimitReport {
  std::vector<LimitViolation> clamped{};
  std::vector<TooFast> lengthened{};
  std::vector<TooFast> too_fast{};
  std::vector<LimitViolation> beyond{};
  LimitExcess excess{};
};

// The report of a move. The checks are made in the order of the members, and end with the first
// that refuses the move.
//
// motion    number of the motion in the cell; -1: none was started.
// refusal   why not; nothing: the move has passed all checks.
// target    of several targets, the index of the one that was refused; -1: not one of them.
// planned   its motion is moved into the cell by make_move unless the caller wants to keep it.
// around    the straight motion collides, so that this motion around obstacles replaces it.
// torques   compared with those of the motors.
struct MoveReport {
  int motion = -1;
  std::optional<Refusal> refusal{};
  int target = -1;
  PlannedMove planned{};
  LimitReport limits{};
  std::optional<Trajectory> around{};
  TorqueReport torques{};
  CollisionReport collisions{};

  [[nodiscard]] bool ok() const { return !refusal.has_value(); }
};

}  // namespace armlet
