// A checked move: from a command to a motion that runs in the cell, or to the reason why not.
//
//   Cell cell(world);
//   cell.add_robot(make_robot("puma560"));
//   const MoveReport report = make_move(cell, {}, {.target = JointTarget{q}, .time = 2.0});
//   if (!report.ok()) std::cerr << to_text(cell, report);
//   cell.advance_to(to_ns(2.0));
#pragma once

#include <optional>
#include <string>

#include "armlet/control/move_report.hpp"
#include "armlet/trajectory/planner.hpp"

namespace armlet {

// Chooses the model of the move (tool point, accelerations, limits), plans the motion, compares its
// torques with those of the motors, looks for collisions and starts it. Each step does what the
// policies of the command say; a refused move leaves the cell as it is.
//
// A robot that decelerates after a velocity command continues with its present speed, if the target
// is one of joint values or a pose, the planner "Syn" or "SCurve", and no time is given.
//
// planners  in which the planner of a joint move is found.
// returns   the report. refused::Invalid has the sentence of a precondition of a line, path or
//           motion around obstacles that is broken.
// throws    ArgumentError for a robot that does not exist, and what a planner of joint moves
//           throws.
MoveReport make_move(Cell& cell, const PlannerSet& planners, const MoveCommand& command);

// Plans and checks the move without the start.
MoveReport plan_move(const Cell& cell, const PlannerSet& planners, const MoveCommand& command);

// A motion of the robot at rest to a JointTarget that keeps away from obstacles, searched even if
// the straight motion collides with nothing; its torques are checked.
MoveReport plan_around(const Cell& cell, const MoveCommand& command, const WayOptions& search);

// The robot itself if it moves, or a moving part of the same hand with fingers; nothing: it is at
// rest.
[[nodiscard]] std::optional<int> moving_part(const Cell& cell, int robot);

// Whether a value is a fraction of the limits of the joints that a move can have: not so small that
// a revolution would take years, and at most 1.
inline constexpr double kLeastFraction = 1e-9;
[[nodiscard]] constexpr bool is_fraction(double value) {
  return value >= kLeastFraction && value <= 1.0;
}

// The lower bound of the duration of a straight move of the tool over a distance, s.
[[nodiscard]] double least_time(double distance, std::optional<double> speed,
                                std::optional<double> accel);

// Why a move was refused, as a sentence for hosts without the language; "" if it was not.
[[nodiscard]] std::string to_text(const Cell& cell, const MoveReport& report);

}  // namespace armlet
