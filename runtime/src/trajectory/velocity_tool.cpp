#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "trajectory/velocity_command.hpp"
#include "trajectory/velocity_motion.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kLackingAtStart = 1e-6;  // of the velocity asked for
// Parts of the limits on acceleration and jerk with which the tool takes up a velocity; the rest is
// for the joints turning under it. The first that suffices is taken.
constexpr double kShares[] = {0.9, 0.75, 0.6, 0.45, 0.3, 0.2, 0.12, 0.07};
constexpr double kLeastShare = kShares[std::size(kShares) - 1];
// Of the limits, while it is decided how to take up a velocity: planned again in the middle, the
// polynomials differ a little.
constexpr double kWithin = 0.995;
// How much faster the tool may become than the fastest velocity still being taken up, as a
// fraction: while one is taken up, while the joints come to rest after it, while they slow down
// because another velocity cannot be taken up otherwise, and in no case. So the slowing down that
// was possible after one command is possible for the next.
constexpr double kCalm = 0.002;
constexpr double kCalmStop = 0.005;
constexpr double kCalmBrake = 0.008;
constexpr double kNotCalm = 0.01;

ToolSpeeds speeds_of(const Vector6d& twist) {
  return {.v = twist.head<3>().norm(), .w = twist.tail<3>().norm()};
}

ToolSpeeds larger(const ToolSpeeds& a, const ToolSpeeds& b) {
  return {.v = std::max(a.v, b.v), .w = std::max(a.w, b.w)};
}

// By which fraction a velocity exceeds the largest speeds. A speed of moving that is small beside
// that of turning counts as a part of it, and the other way round.
double excess_of(const Vector6d& twist, const ToolSpeeds& most) {
  constexpr double kNothing = 1e-6;  // m/s
  constexpr double kLever = 0.25;    // m, between turning and moving
  constexpr double kSmall = 0.05;
  const double v = most.v, w = kLever * most.w;
  const auto excess = [=](double x, double limit, double unit) {
    return x > limit + kNothing ? (x - limit - kNothing) / std::max(unit, kNothing) : 0.0;
  };
  return std::max(excess(twist.head<3>().norm(), v, std::max(v, kSmall * w)),
                  excess(kLever * twist.tail<3>().norm(), w, std::max(w, kSmall * v)));
}

// The same for a motion between two times.
double excess_of(const Robot& robot, const Trajectory& motion, double begin, double end,
                 const ToolSpeeds& most) {
  constexpr int kSamples = 48;
  VectorXd q(robot.n()), qd(robot.n()), qdd(robot.n());
  double excess = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    motion.sample(begin + (end - begin) * k / kSamples, q, qd, qdd);
    excess = std::max(excess, excess_of(jacobian(robot, q) * qd, most));
  }
  return excess;
}

// What the tool does at the start, and would do if the joints stopped gaining speed.
ToolSpeeds speeds_at(const Robot& robot, const VelocityStart& start) {
  const VectorXd qdd = accelerations_of(start);
  const double fading = (qdd.array().abs() / robot.max_jerk().array()).maxCoeff();
  const Jacobian J = jacobian(robot, start.q);
  const Vector6d now = J * start.qd;
  return larger(speeds_of(now), speeds_of(now + J * qdd * (0.5 * fading)));
}

// The largest speeds still being taken up at the start; infinite if they are not known.
ToolSpeeds known_speeds(const Robot& robot, const VelocityStart& start) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const bool rests = start.qd.isZero(0.0) && accelerations_of(start).isZero(0.0);
  const ToolSpeeds known =
      start.fastest.value_or(rests ? ToolSpeeds{} : ToolSpeeds{kUnknown, kUnknown});
  const bool wrong = excess_of(jacobian(robot, start.q) * start.qd, known) > kNotCalm;
  return wrong ? ToolSpeeds{kUnknown, kUnknown} : known;
}

VelocityStart state_of(const VelocityPieces& pieces, double during) {
  return {.q = pieces.q(), .qd = pieces.qd(), .qdd = pieces.qdd(), .during = during};
}

// A take-up followed to its end, however long the command holds.
//
// fits    the joints keep to their limits on acceleration and jerk.
// ends    they do so until the end, within their limits on position and speed.
// excess  of the tool over the largest speeds.
struct Trial {
  bool fits = true;
  bool ends = true;
  double excess = 0.0;
};

Trial try_take_up(const ToolCommand& command, const ToolSpeeds& most) {
  const Robot& robot = command.robot();
  const double end = command.take_up().duration();
  if (end < kShortestVelocity) return {};
  VelocityPieces pieces(command.start());
  const VectorXd A =
      (1.0 + 1e-9) *
      (kWithin * robot.max_accel()).cwiseMax(accelerations_of(command.start()).cwiseAbs());
  const VelocityPlan followed = command.follow(end, pieces, &A);
  const Trajectory motion = std::move(pieces).made();
  Trial trial{.ends = !followed.too_high && !followed.outside};
  for (int i = 0; i < robot.n() && trial.fits; ++i)
    trial.fits = motion.peak(i, 2) <= A[i] && motion.peak(i, 3) <= kWithin * robot.max_jerk()[i];
  if (trial.fits) trial.excess = excess_of(robot, motion, 0.0, motion.duration(), most);
  return trial;
}

// The law with the largest share of the limits by which the joints keep to them. An acceleration
// that another command has left is turned with the largest share of the jerk if that can be, so
// that no speed goes further than that command would have let it.
struct Choice {
  ToolLaw law{};
  Trial trial{};
};

std::optional<Choice> largest_share(ToolCommand& command, const VectorXd& ref, bool slowly,
                                    const ToolSpeeds& most) {
  for (const double share : kShares) {
    const ToolLaw law{.share = share, .turning = slowly ? share : kShares[0], .ref = ref};
    command.plan(law);
    const Trial trial = try_take_up(command, most);
    if (trial.fits) return Choice{law, trial};
  }
  return std::nullopt;
}

// A law, in joint speeds or in those of the tool, by which the tool keeps to its speeds.
std::optional<Choice> calm_law(const Robot& robot, const VelocityStart& start,
                               const Vector6d& twist, const ToolSpeeds& most, double calm,
                               bool must_end) {
  ToolCommand command(robot, start, twist);
  const bool turns = !accelerations_of(start).isZero(1e-9);
  for (const VectorXd& ref : {VectorXd(), start.q}) {
    for (const bool slowly : {false, true}) {
      if (slowly && !turns) break;
      auto choice = largest_share(command, ref, slowly, most);
      if (choice && choice->trial.excess <= calm && (choice->trial.ends || !must_end))
        return choice;
    }
  }
  return std::nullopt;
}

// Slows down first, for as long as it takes until the velocity can be taken up.
std::optional<ToolTakeUp> brake_first(const Robot& robot, const VelocityStart& start,
                                      const Vector6d& twist, const ToolSpeeds& most) {
  const Vector6d none = Vector6d::Zero();
  const auto brake = calm_law(robot, start, none, most, kCalmBrake, true);
  if (!brake) return std::nullopt;
  ToolCommand command(robot, start, none);
  command.plan(brake->law);
  const double rest = command.take_up().duration();
  constexpr int kParts = 4;
  for (int part = 1; part <= kParts; ++part) {
    const double time = rest * part / kParts;
    VelocityPieces pieces(start);
    static_cast<void>(command.follow(time, pieces));
    const VelocityStart slower = state_of(pieces, start.during);
    if (const auto choice = calm_law(robot, slower, twist, most, kCalmBrake, false))
      return ToolTakeUp{.law = choice->law, .brake_for = time, .brake = brake->law};
  }
  const ToolLaw least{.share = kLeastShare, .turning = kLeastShare};
  return ToolTakeUp{.law = least, .brake_for = rest, .brake = brake->law};
}

// Decides how the velocity is taken up.
ToolTakeUp choose(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                  const ToolSpeeds& most) {
  if (const auto choice = calm_law(robot, start, twist, most, kCalm, false))
    return {.law = choice->law};
  if (auto slower = brake_first(robot, start, twist, most)) return *slower;
  ToolCommand command(robot, start, twist);
  for (const VectorXd& ref : {start.q, VectorXd()}) {
    for (const bool slowly : {false, true}) {
      if (const auto choice = largest_share(command, ref, slowly, most))
        return {.law = choice->law};
    }
  }
  return {.law = {.share = kLeastShare, .turning = kLeastShare}};
}

// Comes to rest by a law that keeps the tool calm, by that of the joints if it does.
// returns  by which fraction the tool exceeds the largest speeds.
double stop(const Robot& robot, VelocityPieces& pieces, const ToolSpeeds& most) {
  VelocityPieces alone(state_of(pieces, 1.0)), joints = pieces;
  come_to_rest(robot, alone);
  come_to_rest(robot, joints);
  const Trajectory motion = std::move(alone).made();
  const double excess = excess_of(robot, motion, 0.0, motion.duration(), most);
  if (excess <= kCalmStop) {
    pieces = joints;
    return excess;
  }
  const VelocityStart start = state_of(pieces, 1.0);
  const Vector6d none = Vector6d::Zero();
  for (const double calm : {kCalmStop, kCalmBrake}) {
    const auto choice = calm_law(robot, start, none, most, calm, true);
    if (!choice) continue;
    ToolCommand command(robot, start, none);
    command.plan(choice->law);
    static_cast<void>(command.follow(command.take_up().duration(), pieces));
    for (Eigen::Index i = 0; i < robot.n(); ++i) pieces.settle(i, 0.0);
    return choice->trial.excess;
  }
  pieces = joints;
  return excess;
}

// The whole motion of a command: take-up, hold and stop, or why the joints cannot.
VelocityPlan run_command(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                         const ToolTakeUp& take_up) {
  VelocityPieces pieces(start);
  const double braking = std::min(take_up.brake_for, start.during);
  if (braking > 0.0) {
    ToolCommand brake(robot, start, Vector6d::Zero());
    brake.plan(take_up.brake);
    VelocityPlan plan = brake.follow(braking, pieces);
    if (plan.too_high || plan.outside) return plan;
  }
  double taken_up = braking;
  bool ends = false;
  if (const double left = start.during - braking; left >= kShortestVelocity) {
    const VelocityStart state = braking > 0.0 ? state_of(pieces, left) : start;
    ToolCommand command(robot, state, twist);
    command.plan(take_up.law);
    VelocityPlan plan = command.follow(left, pieces);
    if (plan.too_high || plan.outside || plan.lacking > 0.0) return plan;
    taken_up += command.take_up().duration();
    ends = taken_up <= start.during;
  }
  const ToolSpeeds most = take_up.fastest;
  taken_up = std::min(taken_up, start.during);
  double excess = stop(robot, pieces, most);
  VelocityPlan plan = checked(robot, std::move(pieces).made());
  if (!plan.motion) return plan;
  plan.take_up = take_up;
  plan.take_up.brake_for -= braking;
  if (plan.take_up.brake_for < kShortestVelocity) {
    plan.take_up.brake_for = 0.0;
    if (ends) plan.take_up.fastest = speeds_of(twist);
  }
  const double until = excess_of(robot, *plan.motion, 0.0, taken_up, most);
  if (excess <= kCalmStop && until <= kCalmBrake) return plan;
  VelocityPieces at_once(start);
  excess = std::max(excess, until);
  if (excess <= (1.0 + kNotCalm) * stop(robot, at_once, most)) return plan;
  return {.faster = excess};
}

}  // namespace

VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist) {
  check_start(robot, start);
  check_finite("twist", twist);
  if (const ToolRates wanted = ToolCommand(robot, start, twist).at(0.0, start.q);
      wanted.lacking > kLackingAtStart)
    return {.lacking = wanted.lacking};
  if (start.same) {
    if (const auto size = start.same->law.ref.size(); size > 0) check_size("ref", size, robot.n());
    VelocityPlan plan = run_command(robot, start, twist, *start.same);
    const bool fits = !plan.too_high || plan.too_high->kind == LimitKind::kSpeed;
    if (fits) return plan;
  }
  const ToolSpeeds known = larger(known_speeds(robot, start), speeds_of(twist));
  const bool is_known = std::isfinite(known.v);
  ToolTakeUp take_up = choose(robot, start, twist,
                              is_known ? known : larger(speeds_at(robot, start), speeds_of(twist)));
  take_up.fastest = known;
  return run_command(robot, start, twist, take_up);
}

}  // namespace armlet
