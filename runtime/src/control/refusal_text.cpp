// Refusals as sentences for hosts without the language.

#include <fmt/format.h>

#include <cmath>

#include "armlet/control/make_move.hpp"
#include "armlet/core/format.hpp"
#include "armlet/kinematics/limits.hpp"

namespace armlet {
namespace {

const char* unit_of(const Robot& robot, int joint) {
  return robot.joint(joint).kind == JointKind::kRevolute ? "N m" : "N";
}

struct Words {
  const Cell& cell;
  const MoveReport& report;

  [[nodiscard]] const Robot& model() const { return *report.planned.model; }
  [[nodiscard]] static std::string seconds(double s) { return format_number(s, 3) + " s"; }

  std::string operator()(const refused::Busy& why) const {
    return fmt::format("\"{}\" is moving already.", cell.robot(why.robot).name);
  }
  std::string operator()(const refused::NoToolPoint&) const {
    return "A hand with fingers has no tool point; command the arm that carries it.";
  }
  std::string operator()(const refused::WrongJointCount& why) const {
    return fmt::format("The target has {} joint values; expected {}.", why.count, model().n());
  }
  std::string operator()(const refused::UnknownPlanner& why) const {
    return fmt::format("There is no planner \"{}\".", why.name);
  }
  std::string operator()(const refused::BadTime& why) const {
    return fmt::format("A move cannot take {:.6g} s; use 0 s or more.", why.seconds);
  }
  std::string operator()(const refused::BadRate& why) const {
    const bool is_tool =
        why.rate == refused::Rate::kToolSpeed || why.rate == refused::Rate::kToolAcceleration;
    return fmt::format("A speed or acceleration of {:.6g} is out of range: it is above 0{}.",
                       why.value, is_tool ? "" : " and at most 1, a fraction of the joint limits");
  }
  std::string operator()(const refused::TooLong& why) const {
    return fmt::format("The move would take {:.6g} s, longer than the time that is left.",
                       why.seconds);
  }
  std::string operator()(const refused::Tilted&) const {
    return "No joint of this arm tilts its tool like the target.";
  }
  std::string operator()(const refused::Unreachable& why) const {
    return explain(model(), why.T_world_goal, why.ik);
  }
  std::string operator()(const refused::LineBlocked& why) const {
    return fmt::format("The tool cannot follow its path beyond {:.0f} % of its length.",
                       100.0 * why.fault.fraction);
  }
  std::string operator()(const refused::OutsideLimits& why) const {
    return describe(model(), why.violation) + ".";
  }
  std::string operator()(const TooFast& why) const {
    return fmt::format("{} is too short: joint {} needs {}.", seconds(why.given), why.joint + 1,
                       seconds(why.least_time));
  }
  std::string operator()(const refused::NoTime& why) const {
    return fmt::format("0 s is too short for a move of {}.", format_mm(why.distance));
  }
  std::string operator()(const refused::SpeedJumps& why) const {
    return fmt::format("With \"{}\" joints jump to their speed, which no drive can do.",
                       why.planner);
  }
  std::string operator()(const refused::StartsElsewhere& why) const {
    return fmt::format("The motion starts with joint {} at {:.6g}, and the joint is at {:.6g}.",
                       why.joint + 1, why.starts, why.stands);
  }
  std::string operator()(const refused::NoWayAround& why) const {
    const std::vector<BlockingBodies>& blocking = why.around.blocking;
    std::string text = "No path around the obstacles was found";
    if (!blocking.empty()) {
      text += fmt::format("; {} and {} are in the way", body_text(cell, blocking[0].body),
                          body_text(cell, blocking[0].other));
    }
    return text + ".";
  }
  std::string operator()(const refused::Collides& why) const {
    return fmt::format("{} and {} would collide {} after the start, {} deep.",
                       body_text(cell, why.met.body), body_text(cell, why.met.other),
                       seconds(why.met.t), format_mm(why.met.depth));
  }
  std::string operator()(const refused::TorqueExceeded&) const {
    if (!report.torques.forces) return report.torques.beyond_numbers;
    const MotionForces& forces = *report.torques.forces;
    const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
    const char* unit = unit_of(model(), forces.nearest);
    return fmt::format("Joint {} would need {:.4g} {} after {}; its motor gives {:.4g} {}.",
                       forces.nearest + 1, std::abs(peak.force), unit, seconds(peak.t), peak.limit,
                       unit);
  }
  std::string operator()(const refused::Invalid& why) const { return why.sentence; }
};

}  // namespace

std::string to_text(const Cell& cell, const MoveReport& report) {
  if (!report.refusal) return {};
  return std::visit(Words{cell, report}, *report.refusal);
}

}  // namespace armlet
