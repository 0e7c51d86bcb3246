#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "trajectory/velocity/velocity_command.hpp"
#include "trajectory/velocity/velocity_motion.hpp"
#include "trajectory/velocity/velocity_rest.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kLackingAtStart = 1e-6;  // of the commanded velocity
// Parts of the limits on acceleration and jerk with which the tool reaches a velocity; the rest is
// for the change of joint directions during it. The first that suffices is used.
constexpr double kShares[] = {0.9, 0.75, 0.6, 0.45, 0.3, 0.2, 0.12, 0.07};
constexpr double kLeastShare = kShares[std::size(kShares) - 1];
// The part of the limits if the joint directions do not change, because all joints only come to
// rest.
constexpr double kAllButAll = 0.99;
// Part of the limits that is used in choosing a law: when the command is planned again in the
// middle, the polynomials differ a little.
constexpr double kWithin = 0.995;
// Fractions by which the tool may exceed the fastest velocity that it is still reaching: during the
// take-up; while the joints come to rest after it; and while they decelerate because another
// velocity cannot be reached otherwise. A larger excess means that the velocity which the tool is
// reaching is not the commanded one. With these fractions a deceleration that was possible after
// one command is mostly possible after the next.
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

// A commanded pure rotation may have a small translation, and a pure translation a small rotation:
// by this fraction of the speed at a distance of a quarter of a metre. This is preferred to
// exceeding the commanded speed by more.
constexpr double kDrift = 0.01;
constexpr double kDrifts[] = {kDrift, 0.05, 0.2};

ToolSpeeds with_drift(const ToolSpeeds& most, double drift = kDrift) {
  constexpr double kLever = 0.25;  // m
  return larger(most, {.v = drift * kLever * most.w, .w = drift / kLever * most.v});
}

// The speeds of the tool at the start, and those that it would have if the joint accelerations
// ended.
ToolSpeeds speeds_at(const Robot& robot, const VelocityStart& start) {
  const VectorXd qdd = accelerations_of(start);
  const double fading = (qdd.array().abs() / robot.max_jerk().array()).maxCoeff();
  const Jacobian J = jacobian(robot, start.q);
  const Vector6d now = J * start.qd;
  return larger(speeds_of(now), speeds_of(now + J * qdd * (0.5 * fading)));
}

// The largest speeds still being reached at the start; infinite if they are not known.
ToolSpeeds known_speeds(const Robot& robot, const VelocityStart& start) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const bool rests = start.qd.isZero(0.0) && accelerations_of(start).isZero(0.0);
  const ToolSpeeds known =
      start.fastest.value_or(rests ? ToolSpeeds{} : ToolSpeeds{kUnknown, kUnknown});
  const bool wrong = excess_of(jacobian(robot, start.q) * start.qd, known) > kNotCalm;
  return wrong ? ToolSpeeds{kUnknown, kUnknown} : known;
}

VelocityStart state_of(const VelocityPieces& pieces) {
  return {.q = pieces.q(), .qd = pieces.qd(), .qdd = pieces.qdd(), .during = 1.0};
}

// Requirements on a law by which a velocity is reached.
//
// most, calm  speeds of the tool, and the fraction by which it may exceed them.
// ends        the joints keep their limits on position and speed until the end.
// stops       from every state on it the joints can come to rest smoothly.
// quickly     the direction of an acceleration may also be changed with nearly all of the jerk.
// excess      null, or the fraction by which it may, and then does, exceed them.
struct Wanted {
  ToolSpeeds most{};
  double calm = std::numeric_limits<double>::infinity();
  bool ends = false;
  bool stops = false;
  bool quickly = false;
  double* excess = nullptr;
};

bool stops_calmly(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most);

enum class Trial { kGood, kWithLess, kBad };  // with a smaller share it may be good

// Whether the joints can come to rest smoothly from the quarter points of a motion.
bool stops_on(const Robot& robot, const Trajectory& motion, const ToolSpeeds& most) {
  constexpr int kParts = 4;
  VelocityStart state{.q = VectorXd(robot.n()),
                      .qd = VectorXd(robot.n()),
                      .qdd = VectorXd(robot.n()),
                      .during = 1.0};
  for (int part = kParts; part >= 1; --part) {
    motion.sample(motion.duration() * part / kParts, state.q, state.qd, state.qdd);
    if (!stops_calmly(robot, state, most)) return false;
  }
  return true;
}

// Follows a take-up to its end, however long the command holds.
Trial try_take_up(const Robot& robot, const VelocityStart& start, const ToolCommand& command,
                  const Wanted& wanted) {
  const double end = command.take_up().duration();
  if (end < kShortestVelocity) return Trial::kGood;
  VelocityPieces pieces(start);
  const VectorXd most_qdd =
      (1.0 + 1e-9) * (kWithin * robot.max_accel()).cwiseMax(accelerations_of(start).cwiseAbs());
  const double calm = wanted.excess != nullptr ? *wanted.excess : wanted.calm;
  const FollowLimits limits{.qdd = most_qdd, .most = wanted.most, .calm = calm};
  const VelocityPlan followed = command.follow(0.0, end, pieces, &limits);
  const double at_end = excess_of(jacobian(robot, pieces.q()) * pieces.qd(), wanted.most);
  const Trajectory motion = std::move(pieces).made();
  const double before = excess_of(robot, motion, 0.0, motion.duration(), wanted.most);
  if (std::max(at_end, before) > calm) return Trial::kBad;
  if (wanted.excess != nullptr) *wanted.excess = std::max(at_end, before);
  for (int i = 0; i < robot.n(); ++i) {
    if (motion.peak(i, 2) > most_qdd[i] || motion.peak(i, 3) > kWithin * robot.max_jerk()[i])
      return Trial::kWithLess;
  }
  const bool ends = !followed.too_high && !followed.outside;
  if (!ends && wanted.ends) return Trial::kBad;
  return wanted.stops && !stops_on(robot, motion, wanted.most) ? Trial::kWithLess : Trial::kGood;
}

std::vector<double> shares_for(const Vector6d& twist, const ToolLaw& law) {
  const bool to_rest = twist.isZero(0.0) && law.ref.size() == 0;
  std::vector<double> shares(std::begin(kShares), std::end(kShares));
  if (to_rest) shares.insert(shares.begin(), kAllButAll);
  return shares;
}

// The shares of the jerk with which the direction of an acceleration left by another command may be
// changed: the largest one, with which no speed goes further than that command would have let it;
// the one of the take-up; and nearly all, if the joint directions hardly change.
constexpr double kAlike = 0.0;
constexpr double kQuickTurns[] = {0.99, 0.97, 0.94};

std::vector<double> turnings_for(const std::vector<double>& shares, bool turns, bool quickly) {
  std::vector<double> turnings = {shares[0]};
  if (turns) turnings.push_back(kAlike);
  if (turns && quickly)
    turnings.insert(turnings.end(), std::begin(kQuickTurns), std::end(kQuickTurns));
  return turnings;
}

// The law with the largest share of the limits with which the joints keep them, if it meets the
// requirements: with a smaller share the joints would only move farther meanwhile.
//
// turning  share of the jerk for changing the direction of an acceleration left by another command.
std::optional<ToolLaw> largest_share(const Robot& robot, const VelocityStart& start,
                                     const Vector6d& twist, ToolLaw law, double turning,
                                     const Wanted& wanted) {
  const std::vector<double> shares = shares_for(twist, law);
  for (const double share : shares) {
    law.share = share;
    law.turning = turning == kAlike ? share : turning;
    const Trial trial = try_take_up(robot, start, ToolCommand(robot, start, twist, law), wanted);
    if (trial == Trial::kGood) return law;
    if (trial == Trial::kBad) break;
  }
  return std::nullopt;
}

// The candidate laws, in joint speeds or in tool speeds. If nothing is known that keeps the tool
// speed within bounds, those in tool speeds come first.
std::vector<ToolLaw> laws_for(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                              bool calm) {
  const ToolLaw of_joints, of_tool{.ref = start.q}, crossing{.ref = start.q, .crosses = true};
  std::vector<ToolLaw> laws = {calm ? of_joints : of_tool, calm ? of_tool : of_joints};
  if (twist.isZero(0.0) && robot.n() >= 6) laws.push_back(crossing);
  return laws;
}

// The first of them that meets the requirements.
std::optional<ToolLaw> find_law(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist, const Wanted& wanted) {
  const bool turns = !accelerations_of(start).isZero(1e-9);
  for (const ToolLaw& law : laws_for(robot, start, twist, std::isfinite(wanted.calm))) {
    for (const double turning : turnings_for(shares_for(twist, law), turns, wanted.quickly)) {
      if (auto found = largest_share(robot, start, twist, law, turning, wanted)) return found;
    }
  }
  return std::nullopt;
}

// The law with the least excess of tool speed, of all with which the joints keep their limits; and
// that excess as a fraction.
struct LeastExcess {
  ToolLaw law{.share = kLeastShare, .turning = kLeastShare};
  double excess = std::numeric_limits<double>::infinity();
};

LeastExcess least_excess(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                         const ToolSpeeds& most, bool ends) {
  LeastExcess least;
  for (ToolLaw law : laws_for(robot, start, twist, true)) {
    const std::vector<double> shares = shares_for(twist, law);
    for (const double share : shares) {
      for (const double turning : turnings_for(shares, true, true)) {
        law.share = share;
        law.turning = turning == kAlike ? share : turning;
        double excess = least.excess;
        const Wanted wanted{.most = most, .ends = ends, .excess = &excess};
        const ToolCommand command(robot, start, twist, law);
        if (try_take_up(robot, start, command, wanted) != Trial::kGood) continue;
        if (excess < least.excess) least = {law, excess};
      }
    }
  }
  return least;
}

// A law by which the tool comes to rest without exceeding its speeds.
std::optional<ToolLaw> calm_stop(const Robot& robot, const VelocityStart& start,
                                 const ToolSpeeds& most, bool quickly = false) {
  const Wanted calm{.most = most, .calm = kCalmBrake, .ends = true, .quickly = quickly};
  return find_law(robot, start, Vector6d::Zero(), calm);
}

// The fraction by which the tool exceeds its speeds if each joint comes to rest independently.
double excess_of_rest(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most) {
  VelocityPieces alone(start);
  come_to_rest(robot, alone);
  const Trajectory motion = std::move(alone).made();
  return excess_of(robot, motion, 0.0, motion.duration(), most);
}

bool stops_calmly(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most) {
  const ToolSpeeds drifting = with_drift(most);
  return excess_of_rest(robot, start, drifting) <= kCalmStop || calm_stop(robot, start, drifting);
}

// Decelerates first, until the velocity can be reached.
std::optional<ToolTakeUp> brake_first(const Robot& robot, const VelocityStart& start,
                                      const Vector6d& twist, const ToolSpeeds& most, bool stops,
                                      bool quickly = false) {
  const Vector6d none = Vector6d::Zero();
  const auto brake = calm_stop(robot, start, most, quickly);
  if (!brake) return std::nullopt;
  const ToolCommand command(robot, start, none, *brake);
  const double rest = command.take_up().duration();
  constexpr int kParts = 4;
  for (int part = 1; part <= kParts; ++part) {
    const double time = rest * part / kParts;
    VelocityPieces pieces(start);
    static_cast<void>(command.follow(0.0, time, pieces));
    const VelocityStart slower = state_of(pieces);
    if (const auto law = find_law(robot, slower, twist, {most, kCalmBrake, false, stops}))
      return ToolTakeUp{.law = *law, .brake_for = time, .brake = *brake};
  }
  if (stops) return std::nullopt;
  const ToolLaw least{.share = kLeastShare, .turning = kLeastShare};
  return ToolTakeUp{.law = least, .brake_for = rest, .brake = *brake};
}

// If every law exceeds the speeds: the one with the least excess, of those that reach the velocity
// at once and those that bring the tool to rest first.
ToolTakeUp least_fast(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                      const ToolSpeeds& most) {
  const LeastExcess at_once = least_excess(robot, start, twist, most, false);
  const LeastExcess brake = least_excess(robot, start, Vector6d::Zero(), most, true);
  if (!(brake.excess < at_once.excess)) return {.law = at_once.law};
  const ToolCommand command(robot, start, Vector6d::Zero(), brake.law);
  return {.law = {.share = kLeastShare, .turning = kLeastShare},
          .brake_for = command.take_up().duration(),
          .brake = brake.law};
}

// Chooses the law by which the velocity is reached.
ToolTakeUp choose(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                  const ToolSpeeds& most) {
  const ToolSpeeds drifting = with_drift(most);
  for (const bool stops : {true, false}) {
    for (const ToolSpeeds& fastest : {most, drifting}) {
      if (const auto law = find_law(robot, start, twist, {fastest, kCalm, false, stops}))
        return {.law = *law};
      if (auto slower = brake_first(robot, start, twist, fastest, stops)) return *slower;
    }
  }
  for (const double drift : kDrifts) {
    const ToolSpeeds fastest = with_drift(most, drift);
    const Wanted wanted{.most = fastest, .calm = kCalm, .quickly = true};
    if (const auto law = find_law(robot, start, twist, wanted)) return {.law = *law};
    if (auto slower = brake_first(robot, start, twist, fastest, false, true)) return *slower;
  }
  return least_fast(robot, start, twist, drifting);
}

// Brings the tool to rest with a law.
void stop_by(const Robot& robot, const VelocityStart& start, const ToolLaw& law,
             VelocityPieces& pieces) {
  const ToolCommand command(robot, start, Vector6d::Zero(), law);
  static_cast<void>(command.follow(0.0, command.take_up().duration(), pieces));
  for (Eigen::Index i = 0; i < robot.n(); ++i) pieces.settle(i, 0.0);
}

// Brings all joints to rest together if the tool speed stays within bounds then, else with the law
// that keeps it there, else each joint independently; if none does, in the manner with the least
// excess.
void stop(const Robot& robot, VelocityPieces& pieces, const ToolSpeeds& most) {
  const VelocityStart start = state_of(pieces);
  const ToolSpeeds drifting = with_drift(most);
  for (const ToolSpeeds& fastest : {most, drifting}) {
    if (excess_of_rest(robot, start, fastest) <= kCalmStop) return come_to_rest(robot, pieces);
    if (const auto law = calm_stop(robot, start, fastest))
      return stop_by(robot, start, *law, pieces);
  }
  std::optional<Rest> apart;  // with the least drift
  for (const double drift : kDrifts) {
    const ToolSpeeds fastest = with_drift(most, drift);
    if (const auto law = calm_stop(robot, start, fastest, true))
      return stop_by(robot, start, *law, pieces);
    const Rest rest = calmest_rest(robot, start, fastest, kCalmStop);
    if (rest.excess <= kCalmStop) return come_to_rest_apart(robot, pieces, rest.shares);
    if (!apart) apart = rest;
  }
  const LeastExcess by_law = least_excess(robot, start, Vector6d::Zero(), drifting, true);
  const double together = excess_of_rest(robot, start, drifting);
  if (apart->excess < std::min(by_law.excess, together))
    return come_to_rest_apart(robot, pieces, apart->shares);
  if (by_law.excess < together) return stop_by(robot, start, by_law.law, pieces);
  come_to_rest(robot, pieces);
}

VelocityStart origin_of(const ToolTakeUp& take_up) {
  return {.q = take_up.q, .qd = take_up.qd, .qdd = take_up.qdd, .during = 1.0};
}

void begin_at(ToolTakeUp& take_up, const VelocityStart& state) {
  take_up.q = state.q;
  take_up.qd = state.qd;
  take_up.qdd = accelerations_of(state);
  take_up.elapsed = 0.0;
}

void check_take_up(const Robot& robot, const ToolTakeUp& take_up) {
  for (const VectorXd* x : {&take_up.q, &take_up.qd, &take_up.qdd}) {
    check_size("same", x->size(), robot.n());
    check_finite("same", *x);
  }
  for (const ToolLaw* law : {&take_up.law, &take_up.brake})
    if (law->ref.size() > 0) check_size("ref", law->ref.size(), robot.n());
}

// Whether a state is the one to which a take-up has led.
bool leads_to(const Robot& robot, const ToolTakeUp& take_up, const Vector6d& twist,
              const VelocityStart& state) {
  constexpr double kApart = 1e-6;  // of the largest speeds and accelerations
  const bool brakes = take_up.brake_for > 0.0;
  const ToolCommand command(robot, origin_of(take_up), brakes ? Vector6d(Vector6d::Zero()) : twist,
                            brakes ? take_up.brake : take_up.law);
  const VectorXd qd = command.at(take_up.elapsed, state.q).qd;
  const VectorXd qdd = command.slope(take_up.elapsed, state.q, state.qd);
  const auto near = [=](const VectorXd& a, const VectorXd& b, const VectorXd& most) {
    return ((a - b).array().abs() <= kApart * most.array()).all();
  };
  return near(qd, state.qd, robot.max_speed()) &&
         near(qdd, accelerations_of(state), robot.max_accel());
}

// Follows a command for `time` seconds, from the present state of its take-up.
VelocityPlan go_on(const ToolCommand& command, double time, ToolTakeUp& take_up,
                   VelocityPieces& pieces) {
  VelocityPlan plan = command.follow(take_up.elapsed, take_up.elapsed + time, pieces);
  take_up.elapsed += time;
  return plan;
}

// The whole motion of a command: take-up, hold and stop, or why the joints cannot.
VelocityPlan run_command(const Robot& robot, const VelocityStart& start, const Vector6d& twist,
                         ToolTakeUp take_up) {
  VelocityPieces pieces(start);
  double left = start.during;
  if (take_up.brake_for > 0.0) {
    const double braking = std::min(take_up.brake_for - take_up.elapsed, left);
    const ToolCommand brake(robot, origin_of(take_up), Vector6d::Zero(), take_up.brake);
    VelocityPlan plan = go_on(brake, braking, take_up, pieces);
    if (plan.too_high || plan.outside) return plan;
    left -= braking;
    if (take_up.brake_for - take_up.elapsed < kShortestVelocity) {
      take_up.brake_for = 0.0;
      begin_at(take_up, state_of(pieces));
    }
  }
  if (left >= kShortestVelocity) {
    const ToolCommand command(robot, origin_of(take_up), twist, take_up.law);
    const double rest = std::max(command.take_up().duration() - take_up.elapsed, 0.0);
    VelocityPlan plan = go_on(command, left, take_up, pieces);
    if (plan.too_high || plan.outside || plan.lacking > 0.0) return plan;
    if (rest <= left) take_up.fastest = speeds_of(twist);
  }
  stop(robot, pieces, take_up.fastest);
  VelocityPlan plan = checked(robot, std::move(pieces).made());
  plan.take_up = std::move(take_up);
  return plan;
}

}  // namespace

VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist) {
  check_start(robot, start);
  check_finite("twist", twist);
  const ToolCommand asked(robot, start, twist, {});
  if (const ToolRates wanted = asked.at(asked.take_up().duration(), start.q);
      wanted.lacking > kLackingAtStart)
    return {.lacking = wanted.lacking};
  if (start.same) {
    check_take_up(robot, *start.same);
    if (leads_to(robot, *start.same, twist, start)) {
      VelocityPlan plan = run_command(robot, start, twist, *start.same);
      // Another law may need less of the joints; the speeds at the end are the same with all of
      // them.
      const bool by_the_law = plan.too_high && plan.too_high->kind != LimitKind::kSpeed;
      if (!by_the_law) return plan;
    }
  }
  const ToolSpeeds known = larger(known_speeds(robot, start), speeds_of(twist));
  const bool is_known = std::isfinite(known.v);
  ToolTakeUp take_up = choose(robot, start, twist,
                              is_known ? known : larger(speeds_at(robot, start), speeds_of(twist)));
  take_up.fastest = known;
  begin_at(take_up, start);
  return run_command(robot, start, twist, take_up);
}

}  // namespace armlet
