// Trajectories as values: making and reading them (language reference, sections 13.2 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "motion_text.hpp"
#include "rules.hpp"
#include "trajectories.hpp"

namespace armlet::bind {
namespace {

// ---- making
// ----------------------------------------------------------------------------------------------------

// The parameters behind the robot: (name, points, time, durations, speed, accel). In one signature
// the robot comes first, so that calls without one mean the robot of the program; in the other it
// is the setting `robot`, the last one.
enum Parameter { kName, kPoints, kTime, kDurations, kSpeed, kAccel, kCount };

template <bool kRobotFirst>
MoveCall call_of(const Slot* args) {
  constexpr int kFirst = kRobotFirst ? 1 : 0;
  return {.function = "trajectory",
          .robot = host_value<RobotRef>(args[kRobotFirst ? 0 : kCount]).id,
          .target = kFirst + kPoints,
          .time = kFirst + kTime,
          .speed = kFirst + kSpeed,
          .accel = kFirst + kAccel,
          .planner = kFirst + kName};
}

std::optional<double> given(Slot s) {
  return is_absent(s) ? std::nullopt : std::optional<double>(s.d);
}

// args from the name on.
PointSettings settings_from(const Slot* args, int durations_parameter) {
  PointSettings settings;
  settings.move = {
      .time = given(args[kTime]), .speed = given(args[kSpeed]), .accel = given(args[kAccel])};
  settings.durations_parameter = durations_parameter;
  if (args[kDurations].o == nullptr) return settings;
  const auto durations = reals_value(args[kDurations]);
  settings.durations.assign(durations.begin(), durations.end());
  return settings;
}

Signal give_motion(Vm& vm, Slot* args, const MoveCall& call, std::string planner,
                   std::optional<Trajectory> motion) {
  if (!motion) return Signal::kFail;
  std::shared_ptr<const Robot> robot = Host::of(vm).cell().robot(call.robot).model;
  const PosJ joints = make_posj(*robot, motion->start());
  return give(
      args, new_trajectory(vm, {std::move(planner), *std::move(motion), joints, std::move(robot)}));
}

template <bool kRobotFirst>
Signal make_from_joints(Vm& vm, Slot* args) {
  const MoveCall call = call_of<kRobotFirst>(args);
  const Slot* first = args + (kRobotFirst ? 1 : 0);
  const auto points = joint_points(vm, call, first[kPoints]);
  if (!points) return Signal::kFail;
  std::string planner(text_value(first[kName]));
  const PointSettings settings = settings_from(first, call.target + 2);
  auto motion = plan_through(vm, call, *points, planner, settings);
  return give_motion(vm, args, call, std::move(planner), std::move(motion));
}

template <bool kRobotFirst>
Signal make_from_places(Vm& vm, Slot* args) {
  const MoveCall call = call_of<kRobotFirst>(args);
  const Slot* first = args + (kRobotFirst ? 1 : 0);
  const PointSettings settings = settings_from(first, call.target + 2);
  const auto places = places_in_world(vm, call, settings.move, first[kPoints]);
  if (!places) return Signal::kFail;
  const auto points = solved_points(vm, call, *places, Host::of(vm).cell().robot(call.robot).q);
  if (!points) return Signal::kFail;
  std::string planner(text_value(first[kName]));
  auto motion = planner == "Lin" && !points->empty()
                    ? plan_lines(vm, call, points->front(), *places, settings)
                    : plan_through(vm, call, *points, planner, settings);
  return give_motion(vm, args, call, std::move(planner), std::move(motion));
}

// ---- reading
// ---------------------------------------------------------------------------------------------------

template <int kOrder>
Answer<Obj*> value_at(Vm& vm, const Trajectory& tr, double t) {
  const PlannedMotion& plan = tr;
  if (!std::isfinite(t)) return not_finite(vm, "a time given to a trajectory", t, 1);
  if constexpr (kOrder == 0) {
    PosJ values = plan.joints;
    for (int i = 0; i < values.n; ++i)
      values.q[static_cast<std::size_t>(i)] = plan.motion.value(i, t, kOrder);
    return new_posj(vm, values);
  } else {
    std::vector<double> values;
    for (int i = 0; i < plan.motion.n(); ++i) values.push_back(plan.motion.value(i, t, kOrder));
    return new_reals(vm, values);
  }
}

double duration(const Trajectory& tr) { return tr.motion.duration(); }

Obj* knots(Vm& vm, const Trajectory& tr) { return new_reals(vm, tr.motion.knots()); }

std::string planner_name(const Trajectory& tr) { return tr.planner; }

// (tr, order)
Answer<Obj*> peaks(Vm& vm, const Trajectory& tr, std::int64_t order) {
  const PlannedMotion& plan = tr;
  if (order < 1 || order > Segment::kMaxDegree) {
    return failure(
        vm, "R0609",
        fmt::format("there are no peaks of order {}: 1 is speed, 2 acceleration, 3 jerk", order),
        1);
  }
  std::vector<double> values;
  for (int i = 0; i < plan.motion.n(); ++i) {
    const bool jumps = plan.motion.continuity(i, 1e-6) < order - 1;
    values.push_back(jumps ? std::numeric_limits<double>::infinity()
                           : plan.motion.peak(i, static_cast<int>(order)));
  }
  return new_reals(vm, values);
}

// ---- joining
// ---------------------------------------------------------------------------------------------------

Signal joined(Vm& vm, Slot* args) try {
  const PlannedMotion& first = planned(args[0]);
  const PlannedMotion& next = planned(args[1]);
  std::string planner =
      first.planner == next.planner ? first.planner : first.planner + " + " + next.planner;
  return give(args, new_trajectory(vm, {std::move(planner), first.motion.then(next.motion),
                                        first.joints, first.robot}));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0634", error);
}

Signal reversed(Vm& vm, Slot* args) {
  const PlannedMotion& plan = planned(args[0]);
  return give(args,
              new_trajectory(vm, {plan.planner, plan.motion.reversed(), plan.joints, plan.robot}));
}

// ---- in words
// --------------------------------------------------------------------------------------------------

Signal print_line(Vm& vm, const std::string& text) {
  return vm.print(text + '\n') ? give_nothing() : Signal::kFail;
}

void explain_trajectory(Vm& vm, const Trajectory& tr) {
  const PlannedMotion& plan = tr;
  const std::string what = fmt::format("trajectory {} of {}", plan.planner, plan.robot->name());
  return print_line(vm, explain_motion(what, *plan.robot, plan.motion));
}

void explain_robot(Vm& vm, const RobotRef& r) {
  Host& host = Host::of(vm);
  const int id = r.id;
  const CellRobot& robot = host.cell().robot(id);
  const LastMotion* last = host.last_motion(id);
  if (last == nullptr) {
    return print_line(vm, fmt::format("{} has not moved", robot.name));
  }
  bool moving = false;  // it took over from a velocity command
  for (int i = 0; i < last->motion.n(); ++i) moving |= last->motion.value(i, 0.0, 1) != 0.0;
  return print_line(
      vm, explain_motion(fmt::format("{} of {}", last->function, robot.name), *robot.model,
                         last->motion, last->notes,
                         moving ? Trajectory::Start::kMoving : Trajectory::Start::kAtRest));
}

constexpr std::string_view kMakeHelp =
    "A motion through all points as a value: planned and checked like a move, but nothing moves. "
    "time is the whole duration, durations those of the legs; speed and accel are fractions of the "
    "limits of the joints. Planners that know only two points stop at each. Places are reached by "
    "inverse kinematics, the first from where the robot stands; \"Lin\" joins them by straight "
    "lines.";
constexpr std::string_view kMakeExample =
    "trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s)";
constexpr std::string_view kPlacesExample =
    "trajectory(\"Lin\", [xyz(300mm, 200mm, 150mm), xyz(300mm, -200mm, 150mm)], time: 3s)";
constexpr std::string_view kRobotExample =
    "trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s, robot: "
    "robots.scara(name: \"other\"))";
constexpr std::string_view kRobotPlacesExample =
    "trajectory(\"Spline3\", [xyz(300mm, 200mm, 150mm), xyz(300mm, -200mm, 150mm)], robot: "
    "robots.scara(name: \"other\"))";

constexpr NativeFunction kTrajectoryFunctions[] = {
    {"trajectory",
     "(r: robot, name: string, points: posJ[], time: time?, durations: time[]?, speed: double?, "
     "accel: double?) -> trajectory",
     kMakeHelp, kMakeExample, make_from_joints<true>, nullptr, nullptr, check_trajectory<true>},
    {"trajectory",
     "(r: robot, name: string, points: posC[], time: time?, durations: time[]?, speed: double?, "
     "accel: double?) -> trajectory",
     kMakeHelp, kPlacesExample, make_from_places<true>, nullptr, nullptr, check_trajectory<true>},
    {"trajectory",
     "(name: string, points: posJ[], time: time?, durations: time[]?, speed: double?, accel: "
     "double?, robot: robot) -> trajectory",
     kMakeHelp, kRobotExample, make_from_joints<false>, nullptr, nullptr, check_trajectory<false>},
    {"trajectory",
     "(name: string, points: posC[], time: time?, durations: time[]?, speed: double?, accel: "
     "double?, robot: robot) -> trajectory",
     kMakeHelp, kRobotPlacesExample, make_from_places<false>, nullptr, nullptr,
     check_trajectory<false>},
    def<value_at<0>>(
        "trajectory.q(tr: trajectory, t: time) -> posJ",
        "The joint values at that time; before the start and after the end those of the ends.",
        "trajectory(\"Syn\", [home(), home()], time: 2s).q(1s)"),
    def<value_at<1>>("trajectory.qd(tr: trajectory, t: time) -> double[]",
                     "The joint speeds at that time, rad/s and m/s.",
                     "trajectory(\"Syn\", [home(), home()], time: 2s).qd(1s)"),
    def<value_at<2>>("trajectory.qdd(tr: trajectory, t: time) -> double[]",
                     "The joint accelerations at that time, rad/s^2 and m/s^2. Where one jumps, "
                     "the later value.",
                     "trajectory(\"Syn\", [home(), home()], time: 2s).qdd(1s)"),
    def<value_at<3>>("trajectory.jerk(tr: trajectory, t: time) -> double[]",
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
    {"operator+", "(a: trajectory, b: trajectory) -> trajectory",
     "One motion and then the other, which starts where the first ends.",
     "let tr = trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]); tr + tr.reversed()",
     joined},
    {"trajectory.reversed", "(tr: trajectory) -> trajectory",
     "The same path run backwards in the same time.",
     "trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]).reversed()", reversed},
    def<explain_trajectory>(
        "explain(tr: trajectory)",
        "Prints what a trajectory is made of: for every joint its way and its peaks of speed, "
        "acceleration and jerk, also in percent of the limits; how long this path takes at least, "
        "and "
        "the joint that decides.",
        "explain(trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s))"),
    def<explain_robot>("explain(r: robot)",
                       "Prints the same of the last move of a robot, as it was planned.",
                       "moveJ(posJ(60deg, 30deg, 0mm, 0deg)); explain()"),
};

}  // namespace

std::span<const NativeFunction> trajectory_functions() { return kTrajectoryFunctions; }

}  // namespace armlet::bind
