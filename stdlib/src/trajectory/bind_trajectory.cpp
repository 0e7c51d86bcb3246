// Trajectories as values: planning and reading them (language reference, sections 13.2 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/format.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/robot_text.hpp"
#include "messages/library_messages.hpp"
#include "moves/limit_policy.hpp"
#include "moves/motion_torques.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_words.hpp"
#include "moves/trajectories.hpp"
#include "rules/rules.hpp"
#include "trajectory/motion_text.hpp"
#include "values/bind.hpp"
#include "values/robots/own_pairs.hpp"

namespace armlet::bind {
namespace {

// ---- planning -----------------------------------------------------------------------------------

using Number = std::optional<double>;
using Durations = std::optional<std::span<const double>>;

MoveCall call_of(const RobotRef& r) {
  return {.function = "trajectory", .robot = r.id, .target = at("points"), .planner = at("name")};
}
PointSettings settings_from(const MoveSettings& move, Durations durations) {
  PointSettings settings{.move = move};
  if (durations) settings.durations.assign(durations->begin(), durations->end());
  return settings;
}

Answer<Trajectory> plan(Vm& vm, MoveCall call, const std::string& planner, HostList<PosJ> list,
                        const PointSettings& settings) {
  const auto points = joint_points(vm, call, list);
  if (!points) return Failed{};
  return plan_through(vm, call, *points, planner, settings);
}
Answer<Trajectory> plan(Vm& vm, const MoveCall& call, const std::string& planner,
                        HostList<PosC> list, const PointSettings& settings) {
  const auto places = positions_in_world(vm, call, settings.move, list);
  if (!places) return Failed{};
  const auto points = solved_points(vm, call, *places, Host::of(vm).cell().robot(call.robot).q);
  if (!points) return Failed{};
  return planner == "Lin" && !points->empty()
             ? plan_lines(vm, call, points->front(), *places, settings)
             : plan_through(vm, call, *points, planner, settings);
}
template <class T>
Answer<PlannedMotion> planned_of(Vm& vm, const MoveCall& call, std::string_view name,
                                 HostList<T> points, const PointSettings& settings) {
  std::string planner(name);
  auto motion = plan(vm, call, planner, points, settings);
  if (!motion) return Failed{};
  std::shared_ptr<const Robot> robot = Host::of(vm).cell().robot(call.robot).model;
  const PosJ joints = make_posj(*robot, motion->start());
  return PlannedMotion{std::move(planner), *std::move(motion), joints, std::move(robot)};
}

// Two signatures: one with the robot first, where it may be left out if the program has one robot;
// the other with the robot as the setting `robot`.
template <class T>
Answer<PlannedMotion> make_for(Vm& vm, const RobotRef& r, std::string_view name, HostList<T> points,
                               Number time, Durations durations, Number speed, Number accel) {
  const MoveCall call = call_of(r);
  const MoveSettings move{.time = time, .speed = speed, .accel = accel};
  return planned_of(vm, call, name, points, settings_from(move, durations));
}
template <class T>
Answer<PlannedMotion> make_with(Vm& vm, std::string_view name, HostList<T> points, Number time,
                                Durations durations, Number speed, Number accel,
                                const RobotRef& robot) {
  const MoveCall call = call_of(robot);
  const MoveSettings move{.time = time, .speed = speed, .accel = accel};
  return planned_of(vm, call, name, points, settings_from(move, durations));
}

// The settings of a motion to one target around obstacles.
struct WaySettings {
  Number time, speed, accel;
  bool avoid = true;
  double clearance = 0.0;  // m
  std::int64_t iterations = 0;
};

Answer<WayOptions> search_of(Vm& vm, const WaySettings& settings) {
  constexpr std::int64_t kMost = 1'000'000;
  if (!(settings.clearance > 0.0 && settings.clearance <= 1.0)) {
    return failure(vm, "R0609",
                   fmt::format("a clearance of {}: it lies above 0 mm and not above 1 m",
                               format_mm(settings.clearance)),
                   at("clearance"));
  }
  if (settings.iterations < 1 || settings.iterations > kMost) {
    return failure(
        vm, "R0609",
        fmt::format("{} iterations: a search makes 1 to {} of them", settings.iterations, kMost),
        at("iterations"));
  }
  return WayOptions{.clearance = settings.clearance,
                    .iterations = static_cast<int>(settings.iterations)};
}

Answer<PlannedMotion> plan_to_joints(Vm& vm, MoveCall call, const Eigen::VectorXd& given,
                                     const WaySettings& settings) {
  const Eigen::VectorXd q = clamped(vm, call, given);
  const MoveSettings move{.time = settings.time, .speed = settings.speed, .accel = settings.accel};
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  const PosJ joints = make_posj(*state.model, state.q);
  if (!settings.avoid) {
    auto motion = plan_through(vm, call, {state.q, q}, "Syn", {.move = move});
    if (!motion) return Failed{};
    Host& host = Host::of(vm);
    host.note_way(
        {.t_ns = host.now_ns(), .robot = call.robot, .model = state.model, .motion = *motion});
    return PlannedMotion{"Syn", *std::move(motion), joints, state.model};
  }
  const auto search = search_of(vm, settings);
  if (!search) return Failed{};
  MoveCommand command = command_of(vm, call);
  command.target = JointTarget{q, call.any_branch};
  command.time = settings.time;
  if (settings.speed || settings.time) command.speed = settings.speed;
  command.accel = settings.accel.value_or(command.accel);
  MoveReport report = plan_around(Host::of(vm).cell(), command, *search);
  call.model = report.planned.model;
  advise_planned(vm, call, call, report);
  if (!report.ok()) return fail_move(vm, call, report);
  if (!word_torques(vm, call, report.torques)) return Failed{};
  return PlannedMotion{"Around", *std::move(report.planned.motion), joints, state.model};
}

MoveCall plan_call(const RobotRef& r) {
  return {.function = "plan", .robot = r.id, .target = at("to")};
}
Answer<PlannedMotion> plan_joints(Vm& vm, const RobotRef& r, const PosJ& to, Number time,
                                  Number speed, Number accel, bool avoid, double clearance,
                                  std::int64_t iterations) {
  const MoveCall call = plan_call(r);
  if (!check_idle(vm, r.id)) return Failed{};
  if (to.n != model_of(vm, r).n()) return fail_joint_count(vm, call, to.n);
  return plan_to_joints(vm, call, to.vector(), {time, speed, accel, avoid, clearance, iterations});
}
Answer<PlannedMotion> plan_position(Vm& vm, const RobotRef& r, const PosC& to, Number time,
                                    Number speed, Number accel, bool avoid, double clearance,
                                    std::int64_t iterations) {
  MoveCall call = plan_call(r);
  if (!check_idle(vm, r.id)) return Failed{};
  choose_model(vm, call, {}, 1.0);
  const auto target = in_world(vm, call, {}, to);
  if (!target) return Failed{};
  const auto q = solve_target(vm, call, *target, state_of(vm, r).q);
  if (!q) return Failed{};
  call.any_branch = true;
  return plan_to_joints(vm, call, *q, {time, speed, accel, avoid, clearance, iterations});
}

// ---- reading ------------------------------------------------------------------------------------

Answer<PosJ> joints_at(Vm& vm, const PlannedMotion& tr, double t) {
  if (!std::isfinite(t)) return not_finite(vm, "a time given to a trajectory", t, at("t"));
  PosJ values = tr.joints;
  for (int i = 0; i < values.n; ++i) values.q[static_cast<std::size_t>(i)] = tr.motion.value(i, t);
  return values;
}
template <int kOrder>
Answer<std::vector<double>> rates_at(Vm& vm, const PlannedMotion& tr, double t) {
  if (!std::isfinite(t)) return not_finite(vm, "a time given to a trajectory", t, at("t"));
  const Trajectory& motion = tr.motion;
  std::vector<double> values;
  for (int i = 0; i < motion.n(); ++i) values.push_back(motion.value(i, t, kOrder));
  return values;
}

double duration(const PlannedMotion& tr) { return tr.motion.duration(); }

std::vector<double> knots(const PlannedMotion& tr) { return tr.motion.knots(); }

std::string planner_name(const PlannedMotion& tr) { return tr.planner; }

Answer<std::vector<double>> peaks(Vm& vm, const PlannedMotion& tr, std::int64_t order) {
  if (order < 1 || order > Segment::kMaxDegree) {
    return failure(
        vm, "R0609",
        fmt::format("there are no peaks of order {}: 1 is speed, 2 acceleration, 3 jerk", order),
        at("order"));
  }
  const Trajectory& motion = tr.motion;
  std::vector<double> values;
  for (int i = 0; i < motion.n(); ++i) {
    const bool jumps = motion.continuity(i, 1e-6) < order - 1;
    values.push_back(jumps ? std::numeric_limits<double>::infinity()
                           : motion.peak(i, static_cast<int>(order)));
  }
  return values;
}

// ---- joining ------------------------------------------------------------------------------------

Answer<PlannedMotion> joined(Vm& vm, const PlannedMotion& first, const PlannedMotion& next) try {
  std::string planner =
      first.planner == next.planner ? first.planner : first.planner + " + " + next.planner;
  return PlannedMotion{std::move(planner), first.motion.then(next.motion), first.joints,
                       first.robot};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0634"), error);
}

PlannedMotion reversed(const PlannedMotion& plan) {
  return {plan.planner, plan.motion.reversed(), plan.joints, plan.robot};
}

// ---- as text ------------------------------------------------------------------------------------

Answer<void> print_line(Vm& vm, const std::string& text) {
  if (!vm.print(text + '\n')) return Failed{};
  return {};
}

Answer<void> explain_trajectory(Vm& vm, const PlannedMotion& plan) {
  const std::string what = fmt::format("trajectory {} of {}", plan.planner, plan.robot->name());
  return print_line(vm, explain_motion(what, *plan.robot, plan.motion));
}

Answer<void> explain_robot(Vm& vm, const RobotRef& r) {
  const std::string exempt = exempt_text(*Host::of(vm).cell().robot(r.id).model);
  const std::string move = last_move_text(Host::of(vm), r.id);
  return print_line(vm, exempt.empty() ? move : move + '\n' + exempt);
}

constexpr std::string_view kMakeHelp =
    "A motion through all points as a value: planned and checked like a move, but nothing moves. "
    "time is the whole duration, durations those of the legs; speed and accel are fractions of the "
    "speed and acceleration limits of the joints. Planners that know only two points stop at each. "
    "Places are reached by "
    "inverse kinematics, the first from where the robot stands; \"Lin\" joins them by straight "
    "lines.";
constexpr std::string_view kMakeExample =
    "trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s)";
constexpr std::string_view kPositionsExample =
    "trajectory(\"Lin\", [xyz(300mm, 200mm, 150mm), xyz(300mm, -200mm, 150mm)], time: 3s)";
constexpr std::string_view kRobotExample =
    "trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s, robot: "
    "robots.scara(name: \"other\"))";
constexpr std::string_view kRobotPositionsExample =
    "trajectory(\"Spline3\", [xyz(300mm, 200mm, 150mm), xyz(300mm, -200mm, 150mm)], robot: "
    "robots.scara(name: \"other\"))";

constexpr std::string_view kPlanHelp =
    "A motion from where the robot stands to a target, around what is in the way, as a value for "
    "follow: a way is searched with a fixed seed, made short, rounded, and timed within the limits "
    "of the joints; all of it is certain to meet nothing. clearance is kept from all bodies at "
    "every instant, and of what is nearer at an end at least half of the gap there; iterations is "
    "when the search gives up. time or speed, a fraction of the joint "
    "limits, not both. A target in space is reached by any "
    "solution of its inverse kinematics. With avoid: false the joints go straight, and nothing is "
    "looked at.";

constexpr NativeFunction kTrajectoryFunctions[] = {
    def<plan_joints, plan_position>(
        "plan(r: robot, to: posJ | posC, time: time?, speed: double?, accel: double?, avoid: bool "
        "= true, clearance: length = 5mm, iterations: int = 20000) -> trajectory",
        kPlanHelp, "follow(plan(to: posJ(60deg, 30deg, 0mm, 0deg)))",
        {.check = check_all_of<check_plan, note_motion_of<"r">>}),
    def<make_for<PosJ>, make_for<PosC>>(
        "trajectory(r: robot, name: string, points: posJ[] | posC[], time: time?, durations: "
        "time[]?, speed: double?, accel: double?) -> trajectory",
        kMakeHelp, kMakeExample,
        {.check = check_all_of<check_trajectory<true>, note_motion_of<"r">>}),
    def<make_with<PosJ>, make_with<PosC>>(
        "trajectory(name: string, points: posJ[] | posC[], time: time?, durations: time[]?, speed: "
        "double?, accel: double?, robot: robot) -> trajectory",
        kMakeHelp, kRobotExample,
        {.check = check_all_of<check_trajectory<false>, note_motion_of<"robot">>}),
    def<joints_at>(
        "trajectory.q(tr: trajectory, t: time) -> posJ",
        "The joint values at that time; before the start and after the end those of the ends.",
        "trajectory(\"Syn\", [home(), home()], time: 2s).q(1s)", {.check = note_positions}),
    def<rates_at<1>>("trajectory.qd(tr: trajectory, t: time) -> double[]",
                     "The joint speeds at that time, rad/s and m/s.",
                     "trajectory(\"Syn\", [home(), home()], time: 2s).qd(1s)",
                     {.check = note_speeds}),
    def<rates_at<2>>("trajectory.qdd(tr: trajectory, t: time) -> double[]",
                     "The joint accelerations at that time, rad/s^2 and m/s^2. Where one jumps, "
                     "the later value.",
                     "trajectory(\"Syn\", [home(), home()], time: 2s).qdd(1s)",
                     {.check = note_accels}),
    def<rates_at<3>>("trajectory.jerk(tr: trajectory, t: time) -> double[]",
                     "How fast the joint accelerations change at that time, rad/s^3 and m/s^3. "
                     "Where it jumps, the "
                     "later value.",
                     "trajectory(\"Syn\", [home(), home()], time: 2s).jerk(1s)"),
    def<duration>("trajectory.duration(tr: trajectory) -> time", "How long it takes.",
                  "trajectory(\"Syn\", [home(), home()], time: 2s).duration"),
    def<knots>("trajectory.knots(tr: trajectory) -> time[]",
               "The times at which polynomials begin and end, from 0 to the duration.",
               "trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s).knots"),
    def<planner_name>("trajectory.planner(tr: trajectory) -> string",
                      "The name of the planner that made it.",
                      "trajectory(\"Syn\", [home(), home()], time: 2s).planner"),
    def<peaks>(
        "trajectory.peaks(tr: trajectory, order: int = 1) -> double[]",
        "The largest magnitude of each joint's derivative of this order over the whole motion, "
        "from "
        "the polynomials and not from samples: 1 is speed, 2 acceleration, 3 jerk. It is inf where "
        "the "
        "derivative below jumps, as the acceleration of \"Trap\" and \"Cubic\" does: no jerk is "
        "enough "
        "for that.",
        "trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]).peaks(2)"),
    def<joined>("operator+(a: trajectory, b: trajectory) -> trajectory",
                "One motion and then the other, which starts where the first ends.",
                "let tr = trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]); tr + "
                "tr.reversed()"),
    def<reversed>("trajectory.reversed(tr: trajectory) -> trajectory",
                  "The same path run backwards in the same time.",
                  "trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]).reversed()",
                  {.check = note_motion_of<"tr">}),
    def<explain_trajectory>(
        "explain(tr: trajectory)",
        "Prints what a trajectory is made of: for every joint its way and its peaks of speed, "
        "acceleration and jerk, also in percent of the limits; how long this path takes at least, "
        "and "
        "the joint that decides.",
        "explain(trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s))"),
    def<explain_robot>("explain(r: robot)",
                       "Prints the same of the last move of a robot, as it was planned, and "
                       "which pairs of its links are not compared with each other, and why.",
                       "moveJ(posJ(60deg, 30deg, 0mm, 0deg)); explain()"),
};

}  // namespace

std::span<const NativeFunction> trajectory_functions() { return kTrajectoryFunctions; }

}  // namespace armlet::bind
