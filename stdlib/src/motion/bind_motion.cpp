// Moves (language reference, sections 13.2 and 19).

#include <optional>

#include "armlet/kinematics/forward.hpp"
#include "armlet/stdlib/host.hpp"
#include "motion/splines.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "moves/move_words.hpp"
#include "moves/moves.hpp"
#include "moves/trajectories.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Number = std::optional<double>;

Started move_j_joints(Vm& vm, const RobotRef& r, const PosJ& target, Number time, Number speed,
                      Number accel, std::string_view planner, const PosJ*, Number blend) {
  return move_to_joints(vm, {.function = "moveJ", .robot = r.id}, target.vector(),
                        std::string(planner),
                        {.time = time, .speed = speed, .accel = accel, .blend = blend});
}
Started move_j_position(Vm& vm, const RobotRef& r, const PosC& target, Number time, Number speed,
                        Number accel, std::string_view planner, const PosJ* near, Number blend) {
  const int n = model_of(vm, r).n();
  if (near != nullptr && near->n != n)
    return size_failure(vm, "near", near->n, static_cast<std::size_t>(n));
  return move_to_position(vm, {.function = "moveJ", .robot = r.id}, target,
                          near != nullptr ? near->vector() : Eigen::VectorXd(),
                          std::string(planner),
                          {.time = time, .speed = speed, .accel = accel, .blend = blend});
}

std::optional<Frame> frame_of(const PosC* frame) {
  return frame != nullptr ? std::optional<Frame>(frame->T) : std::nullopt;
}
std::optional<Frame> frame_of(const ObjectRef& frame) { return frame; }
std::optional<Frame> frame_of(const FrameRef& frame) { return frame; }

template <class FrameGiven>
Started move_l(Vm& vm, const RobotRef& r, const PosC& target, Number time, Number speed,
               Number accel, const PosC* tool, FrameGiven frame, Number blend) {
  MoveSettings settings{
      .time = time, .speed = speed, .accel = accel, .frame = frame_of(frame), .blend = blend};
  if (tool != nullptr) settings.T_flange_tool = tool->T;
  return move_on_line(vm, {.function = "moveL", .robot = r.id}, target, settings);
}

Started follow(Vm& vm, const RobotRef& r, const PlannedMotion& plan) {
  const MoveCall call{.function = "follow",
                      .robot = r.id,
                      .target = at("tr"),
                      .time = {},
                      .planner = {},
                      .fixed_time = true};
  MoveCommand command = command_of(vm, call);
  command.target = GivenMotion{.motion = plan.motion, .planner = plan.planner};
  return run_move(vm, call, command);
}

// A motion from the present joint values through all points.
Started through(Vm& vm, MoveCall call, std::vector<Eigen::VectorXd> points,
                const std::string& planner, const MoveSettings& settings) {
  const Eigen::VectorXd& q = Host::of(vm).cell().robot(call.robot).q;
  call.fixed_time = settings.time.has_value();
  // A first point that equals the present joint values does not make a segment.
  if (points.empty() || (points.front() - q).cwiseAbs().maxCoeff() > 1e-9)
    points.insert(points.begin(), q);
  auto motion = plan_through(vm, call, points, planner, {.move = settings});
  if (!motion) return Failed{};
  if (!starts_and_stops(*motion)) return fail_no_ramps(vm, call, planner);
  MoveCommand command = command_of(vm, call);
  command.target =
      GivenMotion{.motion = *std::move(motion), .is_verified = true, .model = call.model};
  return run_move(vm, call, command);
}
Started spline(Vm& vm, MoveCall call, HostList<PosJ> list, std::string_view planner,
               const MoveSettings& settings) {
  auto points = joint_points(vm, call, list);
  if (!points) return Failed{};
  return through(vm, call, *std::move(points), std::string(planner), settings);
}
Started spline(Vm& vm, MoveCall call, HostList<PosC> list, std::string_view planner,
               const MoveSettings& settings) {
  const auto places = positions_in_world(vm, call, settings, list);
  if (!places) return Failed{};
  if (const auto kind = spline_called(planner))
    return move_on_spline(vm, call, *places, *kind, settings);
  choose_model(vm, call, {}, 1.0);
  auto points = solved_points(vm, call, *places, Host::of(vm).cell().robot(call.robot).q);
  if (!points) return Failed{};
  return through(vm, call, *std::move(points), std::string(planner), settings);
}
template <class T>
Started move_spline(Vm& vm, const RobotRef& r, HostList<T> points, Number time,
                    std::string_view planner, Number speed, Number accel) {
  if (!check_idle(vm, r.id)) return Failed{};
  const MoveCall call{.function = "moveSpline", .robot = r.id, .target = at("points")};
  return spline(vm, call, points, planner, {.time = time, .speed = speed, .accel = accel});
}

Started move_circ(Vm& vm, const RobotRef& r, const PosC& via, const PosC& target, Number time,
                  Number speed, Number blend) {
  const MoveCall call{.function = "moveCirc", .robot = r.id};
  return move_on_arc(vm, call, via, target, {.time = time, .speed = speed, .blend = blend});
}

std::unique_ptr<Waiting> halt(Vm& vm, const RobotRef& r) { return halt_robot(vm, r.id); }

Answer<void> set_joints(Vm& vm, const RobotRef& r, const PosJ& given_q) {
  Host& host = Host::of(vm);
  const int id = r.id;
  const CellRobot& robot = host.cell().robot(id);
  MoveCall call{.function = "setJoints", .robot = id, .target = at("q")};
  const Eigen::VectorXd q = clamped(vm, call, given_q.vector());
  if (q.size() != robot.model->n())
    return size_failure(vm, "setJoints", static_cast<std::size_t>(q.size()),
                        static_cast<std::size_t>(robot.model->n()));
  if (const auto outside = limit_violations(*robot.model, q); !outside.empty()) {
    if (settings_of(vm).limits != LimitCheck::kWarn)
      return fail_outside(vm, call, q, outside.front());
    advise_beyond(vm, call, outside);
  }
  if (!check_idle(vm, id)) return Failed{};
  host.cell().set_joints(id, q);
  return {};
}

constexpr std::string_view kMoveJHelp =
    "Moves all joints together; to a position in space, its inverse kinematics is solved first. "
    "time or speed, not both; neither means as fast as the joints allow. speed is a fraction: no "
    "joint "
    "is faster than that share of its speed limit; accelerations stay. accel is a fraction of "
    "their acceleration limits. In a path, blend is how far from the "
    "target its corner may begin.";
constexpr std::string_view kMoveLHelp =
    "Moves the hand along a straight line; the orientation turns evenly. time or speed, not both; "
    "neither means as fast as the joints allow. tool is the point that moves, seen from the "
    "flange; frame is where the target is read. In a path, blend is how far from the target its "
    "corner may begin.";

constexpr std::string_view kMoveSplineHelp =
    "Moves from where the robot stands through every point without stopping there: the joints on a "
    "curve through joint values, the hand on a curve through places, its orientation turning "
    "along. "
    "time is the whole duration; without it, as fast as the joints allow. traj is the planner: "
    "\"Spline3\", \"Spline4\", \"Spline5\" or \"Cubic\", of which the last never swings out; with "
    "any other the joints run through the places.";

constexpr NativeFunction kMotionFunctions[] = {
    def<move_j_joints>("moveJ(r: robot, target: posJ, time: time?, speed: double?, accel: double?, "
                       "traj: string = \"Syn\", near: posJ?, blend: length?) -> Move",
                       kMoveJHelp, "moveJ(home(), time: 2s)",
                       {.check = check_move_joints, .pauses = true, .in_path = true}),
    def<move_j_position>(
        "moveJ(r: robot, target: posC, time: time?, speed: double?, accel: double?, "
        "traj: string = \"Syn\", near: posJ?, blend: length?) -> Move",
        kMoveJHelp, "moveJ(here(), time: 1s)",
        {.check = check_move_position, .pauses = true, .in_path = true}),
    def<move_l<const PosC*>, move_l<const ObjectRef&>, move_l<const FrameRef&>>(
        "moveL(r: robot, target: posC, time: time?, speed: speed?, accel: accel?, tool: posC?, "
        "frame: posC? | object | frame, blend: length?) -> Move",
        kMoveLHelp,
        "moveL(here(), speed: 80mm/s); moveL(xyz(z: 80mm), speed: 80mm/s, frame: object(\"cube\"))",
        {.check = check_move_line, .pauses = true, .in_path = true}),
    def<move_spline<PosJ>, move_spline<PosC>>(
        "moveSpline(r: robot, points: posJ[] | posC[], time: time?, traj: string = \"Spline3\", "
        "speed: double?, accel: double?) -> Move",
        kMoveSplineHelp,
        "moveSpline([posJ(30deg, 60deg, 0mm, 0deg), posJ(60deg, 30deg, 0mm, 0deg)])",
        {.check = check_spline, .pauses = true}),
    def<move_circ>(
        "moveCirc(r: robot, via: posC, target: posC, time: time?, speed: speed?, blend: length?) "
        "-> Move",
        "Moves the hand along the circle over via to target; the orientation turns evenly. time "
        "or speed, not both; neither means as fast as the joints allow. In a path, blend is how "
        "far from the target its corner may begin.",
        "moveJ(xyz(300mm, 200mm, 150mm)); moveCirc(xyz(400mm, 0mm, 150mm), xyz(300mm, "
        "-200mm, 150mm), speed: 100mm/s)",
        {.check = check_arc, .pauses = true, .in_path = true}),
    def<follow>("follow(r: robot, tr: trajectory) -> Move",
                "Executes a trajectory exactly; the robot has to stand where it starts.",
                "follow(trajectory(\"Syn\", [joints(), home()]))", {.pauses = true}),
    def<halt>(
        "halt(r: robot)",
        "Stops the robot under control, along its path and within its limits on acceleration and "
        "jerk, and waits until it stands; the move that is interrupted fails with the kind "
        "Halted.",
        "halt()", {.pauses = true, .interrupts = true}),
    def<set_joints>("setJoints(r: robot, q: posJ)",
                    "Puts a simulated robot into a position without moving it.",
                    "setJoints(home())", {.check = check_joints_of<"q">, .commands = true}),
};

}  // namespace

std::span<const NativeFunction> motion_functions() { return kMotionFunctions; }

}  // namespace armlet::bind
