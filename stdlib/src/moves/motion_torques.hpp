#pragma once
// The torques that motions need, compared with the limits of the motors.

#include <cstdint>
#include <string>

#include "armlet/trajectory/trajectory.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// Torques of a motion beyond the limits of the motors of the robot: advice, or R0642 or R0640 if the
// report refuses the motion. Nothing if the motors suffice.
Answer<void> word_torques(Vm& vm, const MoveCall& call, const TorqueReport& report);

// Checks the motor torques of a velocity command of this duration. It cannot be made slower: it is
// refused where a move would be slowed. Of commands that follow each other directly, those are
// checked during which the clock reaches a multiple of 5 ms (the sampling of moves), and the first.
Answer<void> check_velocity_torques(Vm& vm, const MoveCall& call, const Trajectory& motion,
                                    std::int64_t during_ns);

// The deceleration after a velocity command, executed unless another command follows at once. It is
// stored when the command begins. Its executed part is checked when the robot gets its next
// command, or when the program has ended. Torques beyond the limits are then advice.
void remember_rest(Vm& vm, const MoveCall& call, Trajectory path, int motion);
void report_rest(Vm& vm, int robot);
void report_rests(Vm& vm);

// "120 Nm" or "30 N".
[[nodiscard]] std::string force_text(const Robot& robot, int joint, double force);

// "joint 2 comes nearest to what its motor gives: 120 Nm (64 %) at 0.31 s" in a line of its own;
// empty if no limit is known.
[[nodiscard]] std::string torques_text(const Robot& robot, const Trajectory& motion);

}  // namespace armlet::bind
