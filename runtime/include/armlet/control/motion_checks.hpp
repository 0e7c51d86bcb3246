// Checks of a planned motion before it starts: torques of the motors, collisions, joint limits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/control/policies.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/trajectory/motion_forces.hpp"

namespace armlet {

// The torques of a motion, compared with what the motors of the robot give.
//
// forces          of a motion that exceeds the limit of a motor; nothing: none does, or the motion
//                 is made slower instead.
// duration        of the motion that was compared, s.
// beyond_numbers  why the forces cannot be computed: they exceed the range of numbers, and with it
//                 every limit; empty otherwise.
// slower          how many times slower the motion must be executed, >= 1.
// is_refused      the policy does not allow the motion.
struct TorqueReport {
  std::optional<MotionForces> forces{};
  double duration = 0.0;
  std::string beyond_numbers{};
  double slower = 1.0;
  bool is_refused = false;

  [[nodiscard]] bool is_beyond() const { return forces || !beyond_numbers.empty(); }
};

// Compares a motion of the robot, with all that it carries, with the limits of its motors. With
// TorqueCheck::kLimit the motion is made slower unless its time is fixed.
TorqueReport check_torques(const Cell& cell, int robot, const Trajectory& motion,
                           TorqueCheck wanted, bool fixed_time = false);

// Compares a part of a velocity command with the limits of the motors, from one time to another, s.
// It cannot be made slower.
TorqueReport check_command_torques(const Cell& cell, int robot, const Trajectory& motion,
                                   double from, double until, TorqueCheck wanted);

// A collision that can be confirmed only when the move has ended.
//
// guarded  the move may be stopped before it, and contact of the tool causes a contact force.
// last     the other body is a robot: number of its last motion that was included; nullopt: the
//          other body is no robot, or its whole motion is known.
struct PossibleCollision {
  CellCollision met;
  bool guarded = false;
  std::optional<int> last{};
};

// The collisions of a motion if it started now, in order of time.
//
// possible    not certain yet: a robot at rest may start at the same instant, or a guard may stop
//             the move before.
// is_refused  the policy does not allow the motion; the first certain one is the reason.
struct CollisionReport {
  std::vector<CellCollision> certain{};
  std::vector<PossibleCollision> possible{};
  bool is_refused = false;
};

// Looks for the collisions of a motion as the policies request.
//
// beside  as for find_collisions.
CollisionReport check_collisions(const Cell& cell, int robot, const Trajectory& motion,
                                 const MovePolicies& policies,
                                 std::span<const MotionBeside> beside = {});

// Those of the possible collisions that have happened, when the motion with that number has ended.
std::vector<CellCollision> confirmed_collisions(const Cell& cell, int motion,
                                                const std::vector<PossibleCollision>& possible);

// The largest and smallest joint values of a motion that lie outside the limits, in joint order.
std::vector<LimitViolation> excesses(const Robot& robot, const Trajectory& motion);

// The violation with the largest excess; null: there is none.
[[nodiscard]] const LimitViolation* farthest(const std::vector<LimitViolation>& violations);

// Whether every joint starts from rest and ends at rest, without a jump in its speed.
[[nodiscard]] bool starts_and_stops(const Trajectory& motion);

}  // namespace armlet
