#include "moves/trajectories.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/forward.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_failures.hpp"
#include "values/bind.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {
namespace {

void destroy_trajectory(void* value) { static_cast<TrajectoryValue*>(value)->~TrajectoryValue(); }

bool equal_trajectory(const void* a, const void* b) {
  return static_cast<const TrajectoryValue*>(a)->plan ==
         static_cast<const TrajectoryValue*>(b)->plan;
}

void text_trajectory(const void* value, std::string& out) {
  const PlannedMotion& plan = *static_cast<const TrajectoryValue*>(value)->plan;
  out += fmt::format("trajectory {} of {} joint{}, {} s", plan.planner, plan.joints.n,
                     plan.joints.n == 1 ? "" : "s", format_number(plan.motion.duration(), 6));
}

std::string ordinal(std::size_t k) {
  const std::size_t last = k % 10;
  const bool teen = k % 100 >= 11 && k % 100 <= 13;
  return fmt::format("{}{}", k,
                     teen        ? "th"
                     : last == 1 ? "st"
                     : last == 2 ? "nd"
                     : last == 3 ? "rd"
                                 : "th");
}

// Checks that need no planning.
Answer<void> check_settings(Vm& vm, const MoveCall& call, std::size_t points,
                            const PointSettings& settings) {
  if (points < 2) {
    return failure(vm, "R0613",
                   fmt::format("a trajectory goes through two points or more, not {}", points),
                   call.target);
  }
  if (settings.move.time && !check_duration(vm, *settings.move.time, call.time)) return Failed{};
  if (settings.move.speed && !check_fraction(vm, "a speed", *settings.move.speed, call.speed))
    return Failed{};
  if (settings.durations.empty()) return {};
  if (settings.durations.size() != points - 1) {
    return failure(vm, "R0613",
                   fmt::format("{} durations for {} points", settings.durations.size(), points),
                   at("durations"), fmt::format("there is one for each leg: {}", points - 1));
  }
  for (const double T : settings.durations) {
    if (!std::isfinite(T)) return not_finite(vm, "a duration", T, at("durations"));
    if (!check_time_left(vm, "a leg", T, at("durations"))) return Failed{};
    if (T <= 1e-9)
      return domain_failure(vm, "a leg with a duration", T, "be longer than 0 s", {},
                            at("durations"));
  }
  return {};
}

// Gives the call the robot with the accelerations of its settings.
Answer<void> choose_accelerations(Vm& vm, MoveCall& call, const MoveSettings& settings) {
  const double accel = settings.accel.value_or(settings_of(vm).accel);
  if (!check_fraction(vm, "an acceleration", accel, call.accel)) return Failed{};
  choose_model(vm, call, settings, accel);
  return {};
}

// The trajectory of a plan, or a failure: a curve may exceed limits between its points.
Answer<Trajectory> motion_of(Vm& vm, const MoveCall& call, MotionPlan plan) {
  if (!plan.outside.empty()) return fail_swings_outside(vm, call, plan.outside.front());
  if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
  return *std::move(plan.trajectory);
}

// The whole trajectory, after a check of all limits.
Answer<Trajectory> verified(Vm& vm, MoveCall call, Trajectory motion, Jerk jerk = Jerk::kFree) {
  const bool enforce = !may_be_too_fast(vm, call);
  const auto verify_it = [&] {
    return verify(model_of(vm, call), motion, enforce, jerk, limiting_motors(vm, call));
  };
  MotionPlan plan = verify_it();
  if (!plan.outside.empty() && lift_limits(vm, call)) plan = verify_it();
  if (!plan.ok() && plan.too_fast && call.fixed_time) {
    if (const auto time = lengthened(vm, call, *plan.too_fast)) {
      motion = motion.stretched(*time / motion.duration());
      plan = verify_it();
    }
  }
  if (plan.ok() && plan.too_fast) advise_too_fast(vm, call, *plan.too_fast);
  return motion_of(vm, call, std::move(plan));
}

// A plan through the points in the requested time, or as the blocks around the call allow.
Plan plan_within_policy(Vm& vm, const MoveCall& call, const std::string& planner,
                        MoveRequest& request) {
  const PlannerSet& planners = Host::of(vm).planners();
  Plan plan = planners.plan(planner, request);
  if (plan.trajectory || !plan.too_fast || !request.time || !(*request.time > 0.0)) return plan;
  const double given = *request.time;
  const std::optional<double> longer = lengthened(vm, call, *plan.too_fast);
  if (!longer && !may_be_too_fast(vm, call)) return plan;
  request.time = longer;
  Plan again = planners.plan(planner, request);
  if (!longer && again.trajectory)
    again.trajectory = again.trajectory->stretched(given / again.trajectory->duration());
  return again;
}

}  // namespace

const HostType kTrajectory = {.name = "trajectory",
                              .size = sizeof(TrajectoryValue),
                              .destroy = destroy_trajectory,
                              .equal = equal_trajectory,
                              .text = text_trajectory,
                              .help = "A motion as a function of time.",
                              .noun = "a trajectory"};

Answer<std::vector<Eigen::VectorXd>> joint_points(Vm& vm, MoveCall& call,
                                                  const HostList<PosJ>& list) {
  const Robot& robot = model_of(vm, call);
  std::vector<Eigen::VectorXd> points;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].n != robot.n()) return fail_joint_count(vm, call, list[i].n);
    MoveCall point = call;
    point.element = static_cast<int>(i);
    points.push_back(clamped(vm, point, list[i].vector()));
    if (point.excess.by > call.excess.by) call.excess = point.excess;
  }
  return points;
}

Answer<std::vector<Eigen::VectorXd>> solved_points(Vm& vm, const MoveCall& call,
                                                   const std::vector<PosC>& places,
                                                   Eigen::VectorXd seed) {
  std::vector<Eigen::VectorXd> points;
  for (const PosC& place : places) {
    auto q = solve_target(vm, call, place, seed);
    if (!q) return Failed{};
    seed = *q;
    points.push_back(*std::move(q));
  }
  return points;
}

Answer<std::vector<PosC>> positions_in_world(Vm& vm, const MoveCall& call,
                                             const MoveSettings& settings,
                                             const HostList<PosC>& list) {
  std::vector<PosC> places;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto place = in_world(vm, call, settings, list[i]);
    if (!place) return Failed{};
    places.push_back(*std::move(place));
  }
  return places;
}

Answer<Trajectory> plan_through(Vm& vm, MoveCall call, const std::vector<Eigen::VectorXd>& points,
                                const std::string& planner, const PointSettings& settings) {
  if (!check_settings(vm, call, points.size(), settings)) return Failed{};
  if (!choose_accelerations(vm, call, settings.move)) return Failed{};
  const PlannerSet& planners = Host::of(vm).planners();
  if (!planners.has(planner)) return fail_planner(vm, call, planner);
  if (!settings.durations.empty()) call.time = at("durations");
  const Robot& robot = model_of(vm, call);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto outside = limit_violations(robot, points[k]);
    if (!outside.empty() && settings_of(vm).limits != LimitCheck::kWarn)
      return fail_outside_at(vm, call, ordinal(k + 1), outside.front());
  }
  MoveRequest request{.q0 = points.front(),
                      .q1 = points.back(),
                      .limits = axis_limits(robot),
                      .time = settings.move.time,
                      .speed = settings.move.speed,
                      .via = {points.begin() + 1, points.end() - 1},
                      .durations = settings.durations,
                      .motors = limiting_motors(vm, call)};
  if (!request.time && !request.speed && request.durations.empty())
    request.speed = settings_of(vm).speed;
  try {
    Plan plan = plan_within_policy(vm, call, planner, request);
    if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
    return verified(vm, call, *plan.trajectory);
  } catch (const ArgumentError& error) {
    return failure_of(vm, "R0613", error, call.target);
  }
}

Answer<Trajectory> plan_lines(Vm& vm, MoveCall call, const Eigen::VectorXd& start,
                              const std::vector<PosC>& places, const PointSettings& settings) {
  if (!check_settings(vm, call, places.size(), settings)) return Failed{};
  if (!choose_accelerations(vm, call, settings.move)) return Failed{};
  const double speed = settings.move.speed.value_or(settings_of(vm).speed);
  if (!settings.durations.empty()) call.time = at("durations");
  const Robot& robot = model_of(vm, call);
  Trajectory whole = Trajectory::at_rest(start, 0.0);
  for (std::size_t k = 1; k < places.size(); ++k) {
    LineMove line{.q0 = whole.end(), .T_world_goal = places[k].T};
    line.task = task_of(robot, places[k]).value_or(IkTask::kPose);
    if (!settings.durations.empty()) line.time = settings.durations[k - 1];
    if (!line.time && !settings.move.time) line.speed = speed;
    LinePlan leg = plan_line(robot, line);
    if (leg.fault) return fail_line(vm, call, whole.end(), places[k], *leg.fault);
    const auto motion = motion_of(vm, call, std::move(leg.motion));
    if (!motion) return Failed{};
    whole = whole.then(*motion);
  }
  if (settings.move.time && *settings.move.time < 1e-9 && whole.duration() > 0.0) {
    TooFast fast = least_time(robot, whole, Jerk::kLimited);
    fast.given = *settings.move.time;
    return fail_too_fast(vm, call, fast);
  }
  if (settings.move.time && whole.duration() > 0.0)
    whole = whole.stretched(*settings.move.time / whole.duration());
  call.fixed_time = settings.move.time.has_value();
  return verified(vm, call, std::move(whole), Jerk::kLimited);
}

}  // namespace armlet::bind
