// The reactions to a move that would exceed limits or collide.
#pragma once

namespace armlet {

// How a line is tracked close to a singularity: the whole line as slowly as the joints require
// there; slow only there; or with a small deviation from the line.
enum class Track { kExact, kSlow, kDamped };

// The reaction to a move that requires torques beyond the limits of the motors; kLimit: it is
// planned so that it does not.
enum class TorqueCheck { kReport, kError, kIgnore, kLimit };

// The reaction to a move with a collision.
enum class CollisionCheck { kReport, kError, kIgnore };

// The reaction to a move that would exceed joint limits: it is refused; it is executed within the
// limits; it is executed, and the excess is reported.
enum class LimitCheck { kError, kClamp, kWarn };

// avoid            joint moves go around obstacles; a collision that is left is refused.
// guarded          the caller stops the move on contact: what the tool would press on is no reason
//                  to refuse it.
// touching         the move is meant to touch objects, as closing fingers are.
// report_too_fast  with LimitCheck::kError: a time that is too short is reported, not refused.
struct MovePolicies {
  LimitCheck limits = LimitCheck::kError;
  TorqueCheck torques = TorqueCheck::kReport;
  CollisionCheck collisions = CollisionCheck::kReport;
  Track track = Track::kExact;
  bool avoid = false;
  bool guarded = false;
  bool touching = false;
  bool report_too_fast = false;

  // Whether a motion that exceeds limits on speed or acceleration is executed nevertheless.
  [[nodiscard]] bool may_be_too_fast() const {
    return limits == LimitCheck::kWarn || (report_too_fast && limits == LimitCheck::kError);
  }
  // Whether a motor may not exceed its limit, so that planners take the limits into account.
  [[nodiscard]] bool limits_torques() const { return torques == TorqueCheck::kLimit; }
};

}  // namespace armlet
