#include "moves/move_failures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "armlet/core/format.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "messages/library_messages.hpp"
#include "moves/motion_torques.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The angle between a line and the vertical.
double lean_of(const Vector3d& line) {
  return det::atan2(line.head<2>().norm(), std::abs(line.z()));
}

// The text of an angle, with enough digits to show that it is not zero.
std::string lean_text(double angle) {
  const double degrees = angle * (180.0 / kPi);
  int digits = 1;
  while (digits < 6 && degrees < 0.5 * std::pow(10.0, 1 - digits)) ++digits;
  return format_number(degrees, degrees > 0.0 ? digits : 1) + " deg";
}

constexpr double kVertical = 1e-6;  // rad

// Whether the tool always points straight up or down.
bool is_vertical(const Robot& robot) {
  const auto up = fixed_tilt(robot);
  return up && lean_of(*up) <= kVertical;
}

Failure start(Vm& vm, const MoveCall& call, CallPart part) {
  Failure f;
  f.mark = part;
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  f.place = call.place;
  f.mark_element = call.element;
  return f;
}

std::string millimetres(double length, int digits = 0) {
  return format_number(length * 1000.0, digits) + " mm";
}
// Two lengths with enough digits to differ in print, down to nanometres.
std::array<std::string, 2> distinguished(double a, double b) {
  std::array<std::string, 2> out;
  for (int digits = 0; digits <= 6 && out[0] == out[1]; ++digits) {
    out = {millimetres(a, digits), millimetres(b, digits)};
  }
  return out;
}
std::string up_to_tenth(double length) {
  return fmt::format("{} mm", format_number(std::ceil(length * 1e4 - 1e-6) / 10.0, 1));
}

// The distance of a point from the axis of the first joint.
double from_axis(const Robot& robot, const Vector3d& p) {
  const Vector3d local = robot.T_world_base().inverse() * p;
  return std::hypot(local.x(), local.y());
}

// The point of the straight line between two points that is nearest to that axis.
Vector3d nearest_to_axis(const Robot& robot, const Vector3d& from, const Vector3d& to) {
  const Isometry3d T_base_world = robot.T_world_base().inverse();
  const Eigen::Vector2d a = (T_base_world * from).head<2>();
  const Eigen::Vector2d way = (T_base_world * to).head<2>() - a;
  const double length2 = way.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp(-a.dot(way) / length2, 0.0, 1.0) : 0.0;
  return from + s * (to - from);
}

// Whether a position is too close to that axis for any joint values.
bool is_inside_fold(const Robot& robot, const Eigen::VectorXd& q, const Vector3d& place) {
  IkOptions options;
  options.seed = q;
  options.task = IkTask::kPositionFirst;
  const IkResult result = solve_ik(robot, make_translation(place), options);
  return result.status == IkStatus::kUnreachable &&
         from_axis(robot, place) < from_axis(robot, result.diagnosis.nearest.translation());
}

constexpr double kSameHeight = 0.001;

void say_place(const Robot& robot, const Vector3d& goal, const IkDiagnosis& d, Failure& f) {
  const Vector3d nearest = d.nearest.translation();
  const double goal_out = from_axis(robot, goal);
  const double reach_out = from_axis(robot, nearest);
  const Vector3d up = robot.T_world_base().linear().col(2);
  const bool level = std::abs(up.dot(goal - nearest)) < kSameHeight;
  const auto [asked, reached] = distinguished(goal_out, reach_out);
  if (level && goal_out > reach_out) {
    f.why = fmt::format("the point is {} from the base; `{}` reaches {}", asked, f.resource.name,
                        reached);
    f.fix = fmt::format("bring the target at least {} closer", up_to_tenth(d.distance));
  } else if (level) {
    f.why = fmt::format("the point is {} from the base; `{}` cannot fold closer than {}", asked,
                        f.resource.name, reached);
    f.fix = fmt::format("bring the target at least {} further out", up_to_tenth(d.distance));
  } else {
    f.why = fmt::format("the nearest point that `{}` reaches is {}, {} away", f.resource.name,
                        format_point_mm(nearest), format_mm(d.distance));
    f.fix = fmt::format("bring the target at least {} closer to it", up_to_tenth(d.distance));
  }
}

// Adds the joints that would exceed their limits, and how near the tool gets within the limits.
void say_joints(const Robot& robot, const IkDiagnosis& d, Failure& f) {
  for (const LimitViolation& v : d.violations) {
    const JointKind kind = robot.joint(v.joint).kind;
    f.why +=
        fmt::format("{}joint {} would have to {} to {}, beyond its limit of {}",
                    f.why.empty() ? "" : ", and ", v.joint + 1, joint_word(kind),
                    format_joint_value(kind, v.value, v.limit), format_joint_value(kind, v.limit));
  }
  if (d.distance > 0.0) {
    f.why += fmt::format("; within the limits the hand gets to {}, {} away",
                         format_point_mm(d.nearest.translation()), format_mm(d.distance));
  } else if (d.angle > 0.0) {
    f.why += fmt::format("; within the limits the closest orientation at this place differs by {}",
                         format_deg(d.angle));
  }
}

// The first significant digits of a number above 0, and its power of ten.
struct Digits {
  long mantissa;
  int exponent;
};
Digits digits_of(double value, int count) {
  const std::string text = fmt::format("{:.{}e}", value, count - 1);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  std::erase(mantissa, '.');
  return {std::stol(mantissa), std::stoi(text.substr(e + 1))};
}

// The shortest time with this number of significant digits that is enough when `least` is needed.
// Planners allow for rounding by 1e-9.
std::string rounded_up(double least, int count) {
  if (!std::isfinite(least) || !(least > 0.0)) return format_number(least);
  Digits digits = digits_of(least, count);
  const auto number = [&] {
    return std::stod(fmt::format("{}e{}", digits.mantissa, digits.exponent - count + 1));
  };
  if (number() < least * (1.0 - 1e-10)) ++digits.mantissa;
  return format_number(number(), std::max(count - 1 - digits.exponent, 0));
}

std::string at_least(double least) { return rounded_up(least, 3) + " s"; }

// A time as the program gave it, with more digits than the shortest possible time beside it.
std::string given_time(double s) {
  if (!std::isfinite(s) || !(s > 0.0)) return format_number(s) + " s";
  return format_number(s, std::max(5 - digits_of(s, 6).exponent, 0)) + " s";
}

std::string rate(const Robot& robot, int joint, LimitKind kind, double value) {
  if (kind == LimitKind::kForce) return force_text(robot, joint, value);
  const char* per = kind == LimitKind::kSpeed          ? "/s"
                    : kind == LimitKind::kAcceleration ? "/s^2"
                                                       : "/s^3";
  return format_joint_value(robot.joint(joint).kind, value) + per;
}

}  // namespace

Failed fail_unreachable(Vm& vm, const MoveCall& call, const Isometry3d& goal,
                        const IkResult& result) {
  const Robot& robot = model_of(vm, call);
  Failure f = start(vm, call, call.target);
  const IkDiagnosis& d = result.diagnosis;
  Host& host = Host::of(vm);
  host.note_unreached({.t_ns = host.now_ns(),
                       .robot = call.robot,
                       .T_world_tool = goal,
                       .q_nearest = d.q_nearest,
                       .T_world_nearest = d.nearest,
                       .distance = d.distance,
                       .angle = d.angle});
  switch (result.status) {
    case IkStatus::kJointLimit:
      f.headline = {row("R0601"), {"only with a joint beyond its limits"}};
      say_joints(robot, d, f);
      break;
    case IkStatus::kOrientationUnreachable:
      f.headline = {row("R0601"), {"the hand gets there, but not with this orientation"}};
      f.why =
          fmt::format("the closest orientation at this place differs by {}", format_deg(d.angle));
      if (d.gap.exists()) f.why += fmt::format("; with this one {}", describe(d.gap));
      f.fix =
          fmt::format("turn the target by {} or more, or give only a place", format_deg(d.angle));
      break;
    case IkStatus::kSingularGoal:
      f.headline = {row("R0601"), {"the arm is singular at this place"}};
      f.why = "there it cannot move in every direction, so the joint values are not determined";
      break;
    case IkStatus::kBadRotation:
    case IkStatus::kNotFinite:
    case IkStatus::kBadSize:
      f.headline = {row("R0601"), {std::string(to_text(result.status))}};
      f.why = explain(robot, goal, result);
      break;
    default:
      f.headline = {row("R0601"), {"no joint values bring the hand there"}};
      say_place(robot, goal.translation(), d, f);
      // For the tool point itself, the message already says this.
      if (d.gap.exists() && d.gap.point != GapPoint::kToolPoint)
        f.why += fmt::format("; {}", describe(d.gap));
  }
  return fail(vm, std::move(f));
}

Failed fail_tilted(Vm& vm, const MoveCall& call, const PosC& target) {
  const Robot& robot = model_of(vm, call);
  const Eigen::VectorXd& q = Host::of(vm).cell().robot(call.robot).q;
  const IkResult place = solve_ik(robot, target.T, {.seed = q, .task = IkTask::kPositionFirst});
  if (!place.ok()) return fail_unreachable(vm, call, target.T, place);
  Failure f = start(vm, call, call.target);
  f.headline = {row("R0601"), {"the hand gets there, but not with this orientation"}};
  const Vector3d up = fixed_tilt(robot).value_or(Vector3d::UnitZ());
  const std::string error = lean_text(tilt_error(robot, target.T));
  const std::string tilt = lean_text(lean_of(target.T.linear().row(2)));
  if (is_vertical(robot)) {
    f.why = fmt::format(
        "the tool of `{}` always points straight up or down, and this target is tilted by {}",
        f.resource.name, tilt);
    f.fix = "give only a place and a turn about z";
    return fail(vm, std::move(f));
  }
  f.why = fmt::format(
      "no joint of `{}` tilts its tool, which always leans by {}; this target leans by {}{}, and "
      "the closest orientation differs by {}",
      f.resource.name, lean_text(lean_of(up)), tilt,
      lean_text(lean_of(up)) == tilt ? " to another side of the tool" : "", error);
  f.fix = fmt::format("turn the target by {} or more, or give only a place", error);
  return fail(vm, std::move(f));
}

std::string tilt_reason(const Robot& robot) {
  if (is_vertical(robot))
    return "its tool always points straight up or down, and this position is tilted";
  const Vector3d up = fixed_tilt(robot).value_or(Vector3d::UnitZ());
  return fmt::format("its tool always leans by {}, and this position leans otherwise",
                     lean_text(lean_of(up)));
}

namespace {

Failure outside_limits(Vm& vm, const MoveCall& call, const LimitViolation& outside) {
  const Joint& joint = model_of(vm, call).joint(outside.joint);
  const JointKind kind = joint.kind;
  Failure f = start(vm, call, call.target);
  f.moved.reset();
  f.headline = {row("R0602"),
                {std::to_string(outside.joint + 1), std::string(joint_word(kind)),
                 format_joint_value(kind, outside.value, outside.limit),
                 format_joint_value(kind, joint.lower), format_joint_value(kind, joint.upper)}};
  return f;
}

}  // namespace

Failed fail_outside(Vm& vm, const MoveCall& call, const Eigen::VectorXd& q,
                    const LimitViolation& outside) {
  Failure f = outside_limits(vm, call, outside);
  for (int i = 0; i < q.size(); ++i)
    f.label += fmt::format("{}{}", i > 0 ? ", " : "", format_number(q[i], 3));
  f.label = "{" + f.label + "}";
  f.mark_element = outside.joint;
  f.fix = fmt::format("the value {} was given on line {{line}}", format_number(outside.value, 3));
  return fail(vm, std::move(f));
}

Failed fail_outside_at(Vm& vm, const MoveCall& call, const std::string& which,
                       const LimitViolation& outside) {
  Failure f = outside_limits(vm, call, outside);
  f.why = fmt::format("this is the {} of the points", which);
  return fail(vm, std::move(f));
}

Failed fail_swings_outside(Vm& vm, const MoveCall& call, const LimitViolation& outside) {
  Failure f = outside_limits(vm, call, outside);
  f.why = "the points are inside the limits, but the way between them leaves them";
  f.fix = "add a point where it swings out";
  return fail(vm, std::move(f));
}

Failed fail_elsewhere(Vm& vm, const MoveCall& call, int joint, double starts, double stands) {
  const JointKind kind = model_of(vm, call).joint(joint).kind;
  Failure f = start(vm, call, call.target);
  f.headline = {row("R0634"),
                {fmt::format("`{}` does not stand where the trajectory starts", f.resource.name)}};
  f.why = fmt::format("it starts with joint {} at {}, and the joint is at {}", joint + 1,
                      format_joint_value(kind, starts, stands), format_joint_value(kind, stands));
  f.fix = "go there first: moveJ({arg}.q(0s))";
  return fail(vm, std::move(f));
}

Failed fail_too_fast(Vm& vm, const MoveCall& call, const TooFast& fast) {
  const Robot& robot = model_of(vm, call);
  const JointKind kind = robot.joint(fast.joint).kind;
  Failure f = start(vm, call, call.time);
  f.moved.reset();
  f.headline = {row("R0604"), {given_time(fast.given), at_least(fast.least_time)}};
  const std::string travel = format_joint_value(kind, std::abs(fast.travel));
  const char* verb = kind == JointKind::kRevolute ? "turns" : "slides";
  const std::string limit = rate(robot, fast.joint, fast.kind, fast.limit);
  const char* may = fast.kind == LimitKind::kForce          ? "has a motor that gives at most"
                    : fast.kind == LimitKind::kSpeed        ? "is limited to"
                    : fast.kind == LimitKind::kAcceleration ? "gains speed by at most"
                                                            : "changes its acceleration by at most";
  f.why = fmt::format("joint {} {} {} and {} {}", fast.joint + 1, verb, travel, may, limit);
  f.fix = fmt::format("use time: {}s, or leave time out to move as fast as the joints allow",
                      rounded_up(fast.least_time, fast.least_time < 10.0 ? 2 : 3));
  return fail(vm, std::move(f));
}

void advise_too_fast(Vm& vm, const MoveCall& call, const TooFast& fast) {
  if (fast.kind == LimitKind::kForce) return;  // check_torques refuses it
  const Robot& robot = model_of(vm, call);
  const double excess = fast.given > 0.0 ? fast.least_time / fast.given : 0.0;
  const double needed =
      fast.limit * (fast.kind == LimitKind::kSpeed          ? excess
                    : fast.kind == LimitKind::kAcceleration ? excess * excess
                                                            : excess * excess * excess);
  Failure f = start(vm, call, call.time);
  f.moved.reset();
  f.headline = {row("W0707"),
                {std::to_string(fast.joint + 1), rate(robot, fast.joint, fast.kind, needed),
                 rate(robot, fast.joint, fast.kind, fast.limit)}};
  f.fix = fmt::format("give it at least {}", at_least(fast.least_time));
  vm.advise(f);
}

namespace {

// Three positions determine a circle if they are different and not on one line.
void say_no_circle(NoCircle why, Failure& f) {
  struct Words {
    std::string_view what, fix;
  };
  constexpr Words kWords[] = {
      {"they lie on one line", "move the first place off the line, or use moveL"},
      {"the target is where the hand already is",
       "for a full circle, make two arcs of half a circle each, to different places"},
      {"the first place is where the hand already is",
       "give a first place that lies on the way to the target, or use moveL"},
      {"the first place is the target itself",
       "give a first place that lies on the way to the target, or use moveL"}};
  const Words& words = kWords[static_cast<std::size_t>(why)];
  f.headline =
      Headline::own(row("R0603"), fmt::format("no arc leads over these places: {}", words.what));
  f.why =
      "an arc goes from where the hand is, over the first place, to the second; only three "
      "different places that are not on one line determine its circle";
  f.fix = std::string(words.fix);
}

}  // namespace

Failed fail_line(Vm& vm, const MoveCall& call, const Eigen::VectorXd& start_joints,
                 const PosC& target, const LineFault& fault) {
  if (fault.kind == LineFaultKind::kGoal) return fail_unreachable(vm, call, target.T, fault.ik);
  const Robot& robot = model_of(vm, call);
  Failure f = start(vm, call, call.element >= 0 ? call.target : CallPart::callee());
  const std::string part = fmt::format("{} %", std::lround(std::floor(fault.fraction * 100.0)));
  const bool is_straight = call.way == kStraightLine;
  f.headline = {row("R0603"), {part}};
  if (!is_straight)
    f.headline = Headline::own(
        row("R0603"),
        fmt::format("the {} cannot be followed beyond {} of its length", call.way, part));
  const Vector3d start_point = forward(robot, start_joints).translation();
  const Vector3d closest = nearest_to_axis(robot, start_point, target.T.translation());
  if (fault.kind == LineFaultKind::kNoArc) {
    say_no_circle(fault.no_circle, f);
    return fail(vm, std::move(f));
  }
  if (is_straight && is_inside_fold(robot, start_joints, closest)) {
    f.why = fmt::format(
        "both ends can be reached, but in between the line passes {} from the axis of joint 1, "
        "closer than the arm can fold",
        millimetres(from_axis(robot, closest)));
  } else if (fault.kind == LineFaultKind::kJump) {
    f.why = fmt::format(
        "there joint {} would have to jump, because the {} passes too close to where the arm is "
        "singular",
        fault.joint + 1, is_straight ? "line" : call.way);
  } else if (fault.ik.ok()) {
    f.why =
        "both ends can be reached, but only with different postures of the arm, and it cannot "
        "change between them on the way";
  } else {
    Failure there = start(vm, call, call.target);
    if (fault.ik.status == IkStatus::kJointLimit) say_joints(robot, fault.ik.diagnosis, there);
    if (there.why.empty())
      say_place(robot, fault.T_world_tool.translation(), fault.ik.diagnosis, there);
    f.why = fmt::format("both ends can be reached, but in between {}", there.why);
  }
  f.fix = "use moveJ, or go round through a point in between";
  return fail(vm, std::move(f));
}

Failed fail_joint_count(Vm& vm, const MoveCall& call, int count) {
  const Robot& robot = model_of(vm, call);
  Failure f = start(vm, call, call.target);
  f.headline = Headline::own(
      "R0613", fmt::format("{} joint value{} for a robot with {} joint{}", count,
                           count == 1 ? "" : "s", robot.n(), robot.n() == 1 ? "" : "s"));
  f.why = fmt::format("`{}` has joints: ", f.resource.name);
  for (int i = 0; i < robot.n(); ++i)
    f.why += fmt::format("{}{}", i > 0 ? ", " : "", joint_word(robot.joint(i).kind));
  return fail(vm, std::move(f));
}

Failed fail_no_ramps(Vm& vm, const MoveCall& call, std::string_view planner) {
  Failure f = start(vm, call, call.planner);
  f.headline = Headline::own(
      row("R0604"),
      fmt::format("\"{}\" makes the joints jump to their speed, which no drive can do", planner));
  f.why = "its acceleration has no bound at the ends; it is there to be studied";
  f.fix = "use \"Lin\", which has ramps at both ends";
  return fail(vm, std::move(f));
}

Failed fail_planner(Vm& vm, const MoveCall& call, std::string_view planner) {
  const std::vector<std::string> names = Host::of(vm).planners().names();
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  Failure f = start(vm, call, call.planner);
  f.headline = Headline::own("R0626", fmt::format("there is no trajectory called \"{}\"", planner));
  if (const auto meant = most_similar(planner, candidates))
    f.fix = fmt::format("did you mean \"{}\"?", *meant);
  return fail(vm, std::move(f));
}

Failed fail_no_time(Vm& vm, const MoveCall& call, double distance) {
  Failure f = start(vm, call, call.time);
  f.headline = Headline::own(
      row("R0604"), fmt::format("0 s is too short for this move of {}", format_mm(distance)));
  f.fix = "give a time, or leave it out to move as fast as the joints allow";
  return fail(vm, std::move(f));
}

}  // namespace armlet::bind
