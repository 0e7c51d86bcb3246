#include "trajectory/motion_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/stdlib/robot_text.hpp"
#include "armlet/trajectory/part.hpp"
#include "armlet/trajectory/verify.hpp"
#include "moves/motion_torques.hpp"

namespace armlet::bind {
namespace {

constexpr const char* kPer[] = {"", "/s", "/s^2", "/s^3"};

std::string peak_text(const Robot& robot, const Trajectory& motion, int joint, int order) {
  const double limits[] = {0.0, robot.max_speed()[joint], robot.max_accel()[joint],
                           robot.max_jerk()[joint]};
  const double peak = motion.peak(joint, order);
  return fmt::format("{}{} ({} %)", format_joint_value(robot.joint(joint).kind, peak), kPer[order],
                     format_number(100.0 * peak / limits[order], 1));
}

// The peaks of the derivatives, up to the first one that does not exist since the one before jumps.
std::string peaks_text(const Robot& robot, const Trajectory& motion, int joint,
                       Trajectory::Start start) {
  const int smooth = motion.continuity(joint, 1e-6, start);
  std::string text = peak_text(robot, motion, joint, 1);
  if (smooth < 1) return text + ", and its speed jumps";
  text += ", " + peak_text(robot, motion, joint, 2);
  if (smooth < 2) return text + ", and its acceleration jumps";
  return text + ", " + peak_text(robot, motion, joint, 3);
}

std::string joint_line(const Robot& robot, const Trajectory& motion, int joint,
                       Trajectory::Start start) {
  const JointKind kind = robot.joint(joint).kind;
  const double travel = motion.end()[joint] - motion.start()[joint];
  if (motion.peak(joint, 1) == 0.0) return fmt::format("joint {} stands still", joint + 1);
  return fmt::format("joint {} {} {}: at most {}", joint + 1,
                     kind == JointKind::kRevolute ? "turns" : "slides",
                     format_joint_value(kind, travel), peaks_text(robot, motion, joint, start));
}

// The largest ratio to its limit that any joint reaches, and that joint.
struct Share {
  double part = 0.0;
  int joint = 0;
};

Share largest_share(const Robot& robot, const Trajectory& motion, int order) {
  Share most;
  for (int i = 0; i < robot.n(); ++i) {
    const double limits[] = {0.0, robot.max_speed()[i], robot.max_accel()[i], robot.max_jerk()[i]};
    const double part = motion.peak(i, order) / limits[order];
    if (part > most.part) most = {part, i};
  }
  return most;
}

std::string share_text(const Share& share, std::string_view of) {
  return fmt::format("{} % of {} (joint {})", format_number(100.0 * share.part, 1), of,
                     share.joint + 1);
}

// "0.42 s; joint 1 is closest to a limit: at most 62 % of speed (joint 2), ..."
std::string part_text(const Robot& robot, const Trajectory& part) {
  std::string text = fmt::format("{} s", format_number(part.duration(), 3));
  const Share speed = largest_share(robot, part, 1);
  const Share acceleration = largest_share(robot, part, 2);
  if (speed.part == 0.0) return text + ", at rest";
  const Share& closest = speed.part * speed.part > acceleration.part ? speed : acceleration;
  return text + fmt::format("; joint {} decides; at most {}, {}, {}", closest.joint + 1,
                            share_text(speed, "speed"), share_text(acceleration, "acceleration"),
                            share_text(largest_share(robot, part, 3), "jerk"));
}

// The segments of a planner such as 434. Motions of many segments are sampled curves.
std::vector<MotionPart> pieces_of(const Trajectory& motion) {
  constexpr std::size_t kMostPieces = 12;
  const std::vector<double> knots = motion.knots();
  std::vector<MotionPart> parts;
  if (knots.size() < 3 || knots.size() > kMostPieces + 1) return parts;
  for (std::size_t k = 1; k < knots.size(); ++k)
    parts.push_back({.what = "piece", .end = knots[k]});
  return parts;
}

std::string parts_text(const Robot& robot, const Trajectory& motion,
                       const std::vector<MotionPart>& parts) {
  std::string text;
  double begin = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const MotionPart& part = parts[k];
    const double end = std::clamp(part.end, begin, motion.duration());
    text += fmt::format("\n  {}. {}", k + 1, part.what);
    if (part.missed > 0.0)
      text += fmt::format(", passed by at {} mm", format_number(part.missed * 1000.0, 2));
    text += ": " + part_text(robot, part_of(motion, begin, end));
    begin = end;
  }
  return text;
}

std::string deviation_text(const MotionNotes& notes) {
  if (notes.deviation == 0.0 && notes.turn == 0.0) return {};
  return fmt::format("\n  the hand leaves its way by up to {} mm and {}",
                     format_number(notes.deviation * 1000.0, 3), format_deg(notes.turn));
}

// Motions whose accelerations do not jump were planned with limits on jerk.
Jerk jerk_of(const Trajectory& motion, Trajectory::Start start) {
  for (int i = 0; i < motion.n(); ++i) {
    if (motion.continuity(i, 1e-6, start) < 2) return Jerk::kFree;
  }
  return Jerk::kLimited;
}

}  // namespace

std::string explain_motion(std::string_view what, const Robot& robot, const Trajectory& motion,
                           const MotionNotes& notes, Trajectory::Start start) {
  std::string text = fmt::format("{}: {} s", what, format_number(motion.duration(), 3));
  for (int i = 0; i < robot.n(); ++i) text += "\n  " + joint_line(robot, motion, i, start);
  const std::vector<MotionPart> parts = notes.parts.empty() ? pieces_of(motion) : notes.parts;
  if (parts.size() > 1) text += parts_text(robot, motion, parts);
  text += deviation_text(notes);
  text += torques_text(robot, motion);
  TooFast least = least_time(robot, motion, jerk_of(motion, start));
  const bool by_motors = least.least_time > motion.duration() * (1.0 + 1e-6);
  if (by_motors) least = least_time(robot, motion, Jerk::kFree, &robot);
  if (least.least_time <= 0.0) return text;
  text += fmt::format("\n  this path takes at least {} s: joint {} is limited to {}{}",
                      format_number(least.least_time, 3), least.joint + 1,
                      format_joint_value(robot.joint(least.joint).kind, least.limit),
                      kPer[static_cast<std::size_t>(least.kind) + 1]);
  return text;
}

}  // namespace armlet::bind

namespace armlet {

std::string last_move_text(const Host& host, int robot) {
  const CellRobot& of = host.cell().robot(robot);
  const LastMotion* last = host.last_motion(robot);
  if (last == nullptr) return of.name + " has not moved";
  bool moving = false;  // it began with the speed of a velocity command
  for (int i = 0; i < last->motion.n(); ++i) moving |= last->motion.value(i, 0.0, 1) != 0.0;
  return bind::explain_motion(fmt::format("{} of {}", last->function, of.name), *of.loaded,
                              last->motion, last->notes,
                              moving ? Trajectory::Start::kMoving : Trajectory::Start::kAtRest);
}

}  // namespace armlet
