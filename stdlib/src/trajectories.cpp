#include "trajectories.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/forward.hpp"
#include "bind.hpp"
#include "move_failures.hpp"
#include "time_left.hpp"

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

// What can be refused before anything is planned. False: the failure is set.
bool check_settings(Vm& vm, const MoveCall& call, std::size_t points,
                    const PointSettings& settings) {
  if (points < 2) {
    static_cast<void>(failure(
        vm, "R0613", fmt::format("a trajectory goes through two points or more, not {}", points),
        call.target));
    return false;
  }
  if (settings.move.time && !check_duration(vm, *settings.move.time, call.time)) return false;
  if (settings.move.speed && !check_fraction(vm, "a speed", *settings.move.speed, call.speed))
    return false;
  if (settings.durations.empty()) return true;
  if (settings.durations.size() != points - 1) {
    static_cast<void>(failure(
        vm, "R0613", fmt::format("{} durations for {} points", settings.durations.size(), points),
        settings.durations_parameter, fmt::format("there is one for each leg: {}", points - 1)));
    return false;
  }
  for (const double T : settings.durations) {
    if (!std::isfinite(T)) {
      static_cast<void>(not_finite(vm, "a duration", T, settings.durations_parameter));
      return false;
    }
    if (!check_time_left(vm, "a leg", T, settings.durations_parameter)) return false;
    if (T > 1e-9) continue;
    static_cast<void>(domain_failure(vm, "a leg with a duration", T, "be longer than 0 s", {},
                                     settings.durations_parameter));
    return false;
  }
  return true;
}

// The robot with the accelerations of this call. False: the failure is set.
bool choose_accelerations(Vm& vm, MoveCall& call, const MoveSettings& settings) {
  const double accel = settings.accel.value_or(settings_of(vm).accel);
  if (!check_fraction(vm, "an acceleration", accel, call.accel)) return false;
  choose_model(vm, call, settings, accel);
  return true;
}

// The whole of it, checked once more: a curve may swing beyond its points.
std::optional<Trajectory> verified(Vm& vm, const MoveCall& call, Trajectory motion,
                                   Jerk jerk = Jerk::kFree) {
  MotionPlan plan = verify(model_of(vm, call), std::move(motion), true, jerk);
  if (!plan.outside.empty()) {
    static_cast<void>(fail_swings_outside(vm, call, plan.outside.front()));
  } else if (!plan.trajectory) {
    static_cast<void>(fail_too_fast(vm, call, *plan.too_fast));
  }
  return std::move(plan.trajectory);
}

}  // namespace

const HostType kTrajectory = {.name = "trajectory",
                              .size = sizeof(TrajectoryValue),
                              .destroy = destroy_trajectory,
                              .equal = equal_trajectory,
                              .text = text_trajectory,
                              .help = "A motion as a function of time.",
                              .noun = "a trajectory"};

Obj* new_trajectory(Vm& vm, PlannedMotion plan) {
  return new_host_value(vm, kTrajectory,
                        TrajectoryValue{std::make_shared<const PlannedMotion>(std::move(plan))});
}

std::optional<std::vector<Eigen::VectorXd>> joint_points(Vm& vm, const MoveCall& call, Slot list) {
  const Robot& robot = model_of(vm, call);
  std::vector<Eigen::VectorXd> points;
  for (const Slot item : items_value(list)) {
    points.push_back(posj(item).vector());
    if (points.back().size() == robot.n()) continue;
    static_cast<void>(fail_joint_count(vm, call, static_cast<int>(points.back().size())));
    return std::nullopt;
  }
  return points;
}

std::optional<std::vector<Eigen::VectorXd>> solved_points(Vm& vm, const MoveCall& call,
                                                          const std::vector<PosC>& places,
                                                          Eigen::VectorXd seed) {
  std::vector<Eigen::VectorXd> points;
  for (const PosC& place : places) {
    auto q = solve_target(vm, call, place, seed);
    if (!q) return std::nullopt;
    seed = *q;
    points.push_back(*std::move(q));
  }
  return points;
}

std::optional<std::vector<PosC>> places_in_world(Vm& vm, const MoveCall& call,
                                                 const MoveSettings& settings, Slot list) {
  std::vector<PosC> places;
  for (const Slot item : items_value(list)) {
    auto place = in_world(vm, call, settings, posc(item));
    if (!place) return std::nullopt;
    places.push_back(*std::move(place));
  }
  return places;
}

std::optional<Trajectory> plan_through(Vm& vm, MoveCall call,
                                       const std::vector<Eigen::VectorXd>& points,
                                       const std::string& planner, const PointSettings& settings) {
  if (!check_settings(vm, call, points.size(), settings)) return std::nullopt;
  if (!choose_accelerations(vm, call, settings.move)) return std::nullopt;
  const PlannerSet& planners = Host::of(vm).planners();
  if (!planners.has(planner)) {
    static_cast<void>(fail_planner(vm, call, planner));
    return std::nullopt;
  }
  if (!settings.durations.empty()) call.time = settings.durations_parameter;
  const Robot& robot = model_of(vm, call);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto outside = limit_violations(robot, points[k]);
    if (outside.empty()) continue;
    static_cast<void>(fail_outside_at(vm, call, ordinal(k + 1), outside.front()));
    return std::nullopt;
  }
  MoveRequest request{.q0 = points.front(),
                      .q1 = points.back(),
                      .limits = axis_limits(robot),
                      .time = settings.move.time,
                      .speed = settings.move.speed,
                      .via = {points.begin() + 1, points.end() - 1},
                      .durations = settings.durations};
  if (!request.time && !request.speed && request.durations.empty())
    request.speed = settings_of(vm).speed;
  try {
    Plan plan = planners.plan(planner, request);
    if (plan.trajectory) return verified(vm, call, *std::move(plan.trajectory));
    static_cast<void>(fail_too_fast(vm, call, *plan.too_fast));
  } catch (const ArgumentError& error) {
    static_cast<void>(failure_of(vm, "R0613", error, call.target));
  }
  return std::nullopt;
}

std::optional<Trajectory> plan_lines(Vm& vm, MoveCall call, const Eigen::VectorXd& start,
                                     const std::vector<PosC>& places,
                                     const PointSettings& settings) {
  if (!check_settings(vm, call, places.size(), settings)) return std::nullopt;
  if (!choose_accelerations(vm, call, settings.move)) return std::nullopt;
  const double speed = settings.move.speed.value_or(settings_of(vm).speed);
  if (!settings.durations.empty()) call.time = settings.durations_parameter;
  const Robot& robot = model_of(vm, call);
  Trajectory whole = Trajectory::at_rest(start, 0.0);
  for (std::size_t k = 1; k < places.size(); ++k) {
    LineMove line{.q0 = whole.end(), .T_world_goal = places[k].T};
    line.task = task_of(robot, places[k]).value_or(IkTask::kPose);
    if (!settings.durations.empty()) line.time = settings.durations[k - 1];
    if (!line.time && !settings.move.time) line.speed = speed;
    LinePlan leg = plan_line(robot, line);
    if (leg.fault) {
      static_cast<void>(fail_line(vm, call, whole.end(), places[k], *leg.fault));
      return std::nullopt;
    }
    if (!leg.motion.trajectory) {
      if (leg.motion.outside.empty()) {
        static_cast<void>(fail_too_fast(vm, call, *leg.motion.too_fast));
      } else {
        static_cast<void>(fail_swings_outside(vm, call, leg.motion.outside.front()));
      }
      return std::nullopt;
    }
    whole = whole.then(*leg.motion.trajectory);
  }
  if (settings.move.time && *settings.move.time < 1e-9 && whole.duration() > 0.0) {
    TooFast fast = least_time(robot, whole, Jerk::kLimited);
    fast.given = *settings.move.time;
    static_cast<void>(fail_too_fast(vm, call, fast));
    return std::nullopt;
  }
  if (settings.move.time && whole.duration() > 0.0)
    whole = whole.stretched(*settings.move.time / whole.duration());
  return verified(vm, call, std::move(whole), Jerk::kLimited);
}

double way_between_ends(Vm& vm, const MoveCall& call, const Trajectory& motion) {
  const Robot& robot = model_of(vm, call);
  return (forward(robot, motion.end()).translation() - forward(robot, motion.start()).translation())
      .norm();
}

bool check_follows(Vm& vm, const MoveCall& call, const PlannedMotion& plan) {
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  const Robot& robot = model_of(vm, call);
  if (plan.motion.n() != robot.n()) {
    static_cast<void>(fail_joint_count(vm, call, plan.motion.n()));
    return false;
  }
  const Eigen::VectorXd apart = plan.motion.start() - state.q;
  Eigen::Index joint = 0;
  constexpr double kSamePlace = 1e-6;  // as the cell asks for
  if (apart.cwiseAbs().maxCoeff(&joint) > kSamePlace) {
    static_cast<void>(fail_elsewhere(vm, call, static_cast<int>(joint), plan.motion.start()[joint],
                                     state.q[joint]));
    return false;
  }
  if (!starts_and_stops(plan.motion)) {
    static_cast<void>(fail_no_ramps(vm, call, plan.planner));
    return false;
  }
  return verified(vm, call, plan.motion).has_value();
}

}  // namespace armlet::bind
