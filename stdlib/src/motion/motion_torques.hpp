#pragma once
// What motions ask of the motors, against what these give.

#include <cstdint>
#include <string>

#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Says, as `with (torques:)` wants it, that a motor of the robot of the call cannot do this motion:
// as advice, or as R0642. Gives by how much slower it has to be made, 1 if not at all.
Answer<double> check_torques(Vm& vm, const MoveCall& call, const Trajectory& motion);

// The same of a velocity command that holds for so long, which nothing makes slower: where moves
// would be, it is refused. Of commands that go on with one another, those are looked at during
// which the clock comes to a multiple of 5 ms, as densely as moves are, and the first.
Answer<void> check_velocity_torques(Vm& vm, const MoveCall& call, const Trajectory& motion,
                                    std::int64_t during_ns);

// The way to rest behind a velocity command, which is taken unless another one follows at once:
// kept when the command begins, and compared as far as it was taken when the robot is told to move
// again, or when the program has ended. What motors cannot do then is advice.
void remember_rest(Vm& vm, const MoveCall& call, Trajectory path, int motion);
void report_rest(Vm& vm, int robot);
void report_rests(Vm& vm);

// "120 Nm" or "30 N".
[[nodiscard]] std::string force_text(const Robot& robot, int joint, double force);

// "joint 2 comes nearest to what its motor gives: 120 Nm (64 %) at 0.31 s" in a line of its own;
// empty if no limit is known.
[[nodiscard]] std::string torques_text(const Robot& robot, const Trajectory& motion);

}  // namespace armlet::bind
