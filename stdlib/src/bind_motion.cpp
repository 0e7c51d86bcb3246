// Moves (language reference, sections 13.2 and 19).

#include <optional>

#include "armlet/kinematics/forward.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "move_failures.hpp"
#include "move_waiting.hpp"
#include "moves.hpp"
#include "rules.hpp"
#include "splines.hpp"
#include "trajectories.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

std::optional<double> given(Slot s) {
  return is_absent(s) ? std::nullopt : std::optional<double>(s.d);
}

// (r, target, time, speed, accel, ..., blend)
MoveSettings settings_of_move(const Slot* args) {
  return {.time = given(args[2]),
          .speed = given(args[3]),
          .accel = given(args[4]),
          .blend = given(args[7])};
}
// (r, target, time, speed, accel, traj, near, blend)
Signal move_j_joints(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveJ", .robot = host_value<RobotRef>(args[0]).id};
  return move_to_joints(vm, args, call, posj(args[1]).vector(), std::string(text_value(args[5])),
                        settings_of_move(args));
}
Signal move_j_place(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveJ", .robot = host_value<RobotRef>(args[0]).id};
  const Eigen::VectorXd near = args[6].o != nullptr ? posj(args[6]).vector() : Eigen::VectorXd();
  if (args[6].o != nullptr && near.size() != model_of(vm, call).n())
    return size_failure(vm, "near", static_cast<std::size_t>(near.size()),
                        static_cast<std::size_t>(model_of(vm, call).n()));
  return move_to_place(vm, args, call, posc(args[1]), near, std::string(text_value(args[5])),
                       settings_of_move(args));
}

// (r, target, time, speed, accel, tool, frame, blend)
template <bool kInObject>
Signal move_l(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveL", .robot = host_value<RobotRef>(args[0]).id};
  MoveSettings settings = settings_of_move(args);
  if (args[5].o != nullptr) settings.T_flange_tool = posc(args[5]).T;
  if (kInObject) {
    settings.frame = host_value<ObjectRef>(args[6]).name;
  } else if (args[6].o != nullptr) {
    settings.frame = posc(args[6]).T;
  }
  return move_on_line(vm, args, call, posc(args[1]), settings);
}

// (r, tr)
Signal follow(Vm& vm, Slot* args) {
  const MoveCall call{.function = "follow", .robot = host_value<RobotRef>(args[0]).id};
  const PlannedMotion& plan = planned(args[1]);
  if (refuse_busy(vm, call.robot) || !check_follows(vm, call, plan)) return Signal::kFail;
  return start_motion(vm, args, call, plan.motion, way_between_ends(vm, call, plan.motion));
}

// (r, points, time, traj, speed, accel), from where the robot stands through every point.
Signal through(Vm& vm, Slot* args, const MoveCall& call, std::vector<Eigen::VectorXd> points) {
  const Eigen::VectorXd& q = Host::of(vm).cell().robot(call.robot).q;
  // A point where the robot stands is not a leg of its own.
  if (points.empty() || (points.front() - q).cwiseAbs().maxCoeff() > 1e-9)
    points.insert(points.begin(), q);
  PointSettings settings;
  settings.move = {.time = given(args[2]), .speed = given(args[4]), .accel = given(args[5])};
  const std::string planner(text_value(args[3]));
  auto motion = plan_through(vm, call, points, planner, settings);
  if (!motion) return Signal::kFail;
  if (!starts_and_stops(*motion)) return fail_no_ramps(vm, call, planner);
  const double length = way_between_ends(vm, call, *motion);
  return start_motion(vm, args, call, *std::move(motion), length);
}
MoveCall spline_call(const Slot* args) {
  return {.function = "moveSpline",
          .robot = host_value<RobotRef>(args[0]).id,
          .speed = 4,
          .accel = 5,
          .planner = 3};
}
Signal move_spline_joints(Vm& vm, Slot* args) {
  const MoveCall call = spline_call(args);
  if (refuse_busy(vm, call.robot)) return Signal::kFail;
  auto points = joint_points(vm, call, args[1]);
  return points ? through(vm, args, call, *std::move(points)) : Signal::kFail;
}
Signal move_spline_places(Vm& vm, Slot* args) {
  MoveCall call = spline_call(args);
  if (refuse_busy(vm, call.robot)) return Signal::kFail;
  const MoveSettings settings{
      .time = given(args[2]), .speed = given(args[4]), .accel = given(args[5])};
  const auto places = places_in_world(vm, call, settings, args[1]);
  if (!places) return Signal::kFail;
  if (const auto kind = spline_called(text_value(args[3])))
    return move_on_spline(vm, args, call, *places, *kind, settings);
  choose_model(vm, call, {}, 1.0);
  auto points = solved_points(vm, call, *places, Host::of(vm).cell().robot(call.robot).q);
  return points ? through(vm, args, call, *std::move(points)) : Signal::kFail;
}

// (r, via, target, time, speed, blend)
Signal move_circ(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveCirc",
                      .robot = host_value<RobotRef>(args[0]).id,
                      .target = 2,
                      .time = 3,
                      .speed = 4};
  return move_on_arc(vm, args, call, posc(args[1]), posc(args[2]),
                     {.time = given(args[3]), .speed = given(args[4]), .blend = given(args[5])});
}

void halt(Vm& vm, const RobotRef& r) { return halt_robot(vm, r.id); }

Answer<void> set_joints(Vm& vm, const RobotRef& r, const PosJ& given_q) {
  Host& host = Host::of(vm);
  const int id = r.id;
  const CellRobot& robot = host.cell().robot(id);
  const Eigen::VectorXd q = given_q.vector();
  if (q.size() != robot.model->n())
    return size_failure(vm, "setJoints", static_cast<std::size_t>(q.size()),
                        static_cast<std::size_t>(robot.model->n()));
  const MoveCall call{.function = "setJoints", .robot = id};
  if (const auto outside = limit_violations(*robot.model, q); !outside.empty())
    return fail_outside(vm, call, q, outside.front());
  if (refuse_busy(vm, id)) return Failed{};
  host.cell().set_joints(id, q);
  return {};
}

constexpr std::string_view kMoveJHelp =
    "Moves all joints together; to a position in space, its inverse kinematics is solved first. "
    "time or speed, a fraction of the joint limits, not both; neither means as fast as the joints "
    "allow. accel is a fraction of their acceleration limits. In a path, blend is how far from the "
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
    in_path({"moveJ",
             "(r: robot, target: posJ, time: time?, speed: double?, accel: double?, traj: string = "
             "\"Syn\", near: posJ?, blend: length?) -> Move",
             kMoveJHelp, "moveJ(home(), time: 2s)", move_j_joints, nullptr, nullptr,
             check_move_joints, nullptr, true}),
    in_path({"moveJ",
             "(r: robot, target: posC, time: time?, speed: double?, accel: double?, traj: string = "
             "\"Syn\", near: posJ?, blend: length?) -> Move",
             kMoveJHelp, "moveJ(here(), time: 1s)", move_j_place, nullptr, nullptr,
             check_move_place, nullptr, true}),
    in_path({"moveL",
             "(r: robot, target: posC, time: time?, speed: speed?, accel: accel?, tool: posC?, "
             "frame: posC?, blend: length?) -> Move",
             kMoveLHelp, "moveL(here(), speed: 80mm/s)", move_l<false>, nullptr, nullptr,
             check_move_line, nullptr, true}),
    in_path({"moveL",
             "(r: robot, target: posC, time: time?, speed: speed?, accel: accel?, tool: posC?, "
             "frame: object, blend: length?) -> Move",
             kMoveLHelp, "moveL(xyz(z: 80mm), speed: 80mm/s, frame: object(\"cube\"))",
             move_l<true>, nullptr, nullptr, check_move_line, nullptr, true}),
    {"moveSpline",
     "(r: robot, points: posJ[], time: time?, traj: string = \"Spline3\", speed: "
     "double?, accel: double?) -> Move",
     kMoveSplineHelp, "moveSpline([posJ(30deg, 60deg, 0mm, 0deg), posJ(60deg, 30deg, 0mm, 0deg)])",
     move_spline_joints, nullptr, nullptr, check_spline, nullptr, true},
    {"moveSpline",
     "(r: robot, points: posC[], time: time?, traj: string = \"Spline3\", speed: "
     "double?, accel: double?) -> Move",
     kMoveSplineHelp, "moveSpline([xyz(300mm, 200mm, 200mm), xyz(300mm, -200mm, 200mm)])",
     move_spline_places, nullptr, nullptr, check_spline, nullptr, true},
    {.name = "moveCirc",
     .signature = "(r: robot, via: posC, target: posC, time: time?, speed: speed?, blend: length?) "
                  "-> Move",
     .help =
         "Moves the hand along the circle over via to target; the orientation turns evenly. time "
         "or speed, not both; neither means as fast as the joints allow. In a path, blend is how "
         "far from the target its corner may begin.",
     .example = "moveJ(xyz(300mm, 200mm, 150mm)); moveCirc(xyz(400mm, 0mm, 150mm), xyz(300mm, "
                "-200mm, 150mm), speed: 100mm/s)",
     .thunk = move_circ,
     .check = check_arc,
     .pauses = true,
     .in_path = true},
    {.name = "follow",
     .signature = "(r: robot, tr: trajectory) -> Move",
     .help = "Executes a trajectory exactly; the robot has to stand where it starts.",
     .example = "follow(trajectory(\"Syn\", [joints(), home()]))",
     .thunk = follow,
     .pauses = true},
    def<halt>(
        "halt(r: robot)",
        "Stops the robot under control, along its path and within its limits on acceleration and "
        "jerk, and waits until it stands; the move that is interrupted fails with the kind "
        "Halted.",
        "halt()", {.pauses = true, .interrupts = true}),
    def<set_joints>("setJoints(r: robot, q: posJ)",
                    "Puts a simulated robot into a position without moving it.",
                    "setJoints(home())", {.commands = true}),
};

}  // namespace

std::span<const NativeFunction> motion_functions() { return kMotionFunctions; }

}  // namespace armlet::bind
