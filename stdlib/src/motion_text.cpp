#include "motion_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet::bind {
namespace {

std::string peak_text(const Robot& robot, const Trajectory& motion, int joint, int order) {
  static constexpr const char* kPer[] = {"", "/s", "/s^2", "/s^3"};
  const double limits[] = {0.0, robot.max_speed()[joint], robot.max_accel()[joint],
                           robot.max_jerk()[joint]};
  const double peak = motion.peak(joint, order);
  return fmt::format("{}{} ({} %)", format_joint_value(robot.joint(joint).kind, peak), kPer[order],
                     format_number(100.0 * peak / limits[order], 1));
}

std::string joint_line(const Robot& robot, const Trajectory& motion, int joint) {
  const JointKind kind = robot.joint(joint).kind;
  const double travel = motion.end()[joint] - motion.start()[joint];
  if (motion.peak(joint, 1) == 0.0) return fmt::format("joint {} stands still", joint + 1);
  return fmt::format("joint {} {} {}: at most {}, {}, {}", joint + 1,
                     kind == JointKind::kRevolute ? "turns" : "slides",
                     format_joint_value(kind, travel), peak_text(robot, motion, joint, 1),
                     peak_text(robot, motion, joint, 2), peak_text(robot, motion, joint, 3));
}

}  // namespace

std::string explain_motion(std::string_view what, const Robot& robot, const Trajectory& motion) {
  std::string text = fmt::format("{}: {} s", what, format_number(motion.duration(), 3));
  for (int i = 0; i < robot.n(); ++i) text += "\n  " + joint_line(robot, motion, i);
  const TooFast least = least_time(robot, motion);
  if (least.least_time <= 0.0) return text;
  text += fmt::format("\n  this path takes at least {} s: joint {} is limited to {}{}",
                      format_number(least.least_time, 3), least.joint + 1,
                      format_joint_value(robot.joint(least.joint).kind, least.limit),
                      least.kind == LimitKind::kSpeed ? "/s" : "/s^2");
  return text;
}

}  // namespace armlet::bind
