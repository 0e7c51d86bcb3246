// The classic subset (language reference, section 18): the eight names of the 2011 platform.

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/task_space.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "moves/moves.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/values.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {
namespace {

Failed fail_posc_count(Vm& vm, std::size_t count, const Robot* robot, TaskSpace space) {
  std::string why = "3 are a place, 6 a place with roll, pitch and yaw";
  if (robot == nullptr) {
    why += "; which robot is meant is not known, so no other number of them is";
  } else if (space == TaskSpace::kOther) {
    why += fmt::format("; what `{}` controls of its tool has no coordinates of its own",
                       robot->name());
  } else {
    why += fmt::format("; `{}` controls {}", robot->name(), coordinate_names(space));
  }
  return failure(
      vm, "R0613",
      fmt::format("a posC is made from 3 or 6 numbers, or as many as the robot controls, not {}",
                  count),
      at("values"), std::move(why), robot == nullptr ? "say which: posC(values, of: arm)" : "");
}

// posC(numbers): as many numbers as the arm controls, in the arm's order; 3: a position only; 6:
// position, roll, pitch, yaw (section 8).
Answer<PosC> posc_from(Vm& vm, std::span<const double> v, const RobotRef* of) {
  for (const double x : v) {
    if (!std::isfinite(x)) return not_finite(vm, "a value of the posC", x, at("values"));
  }
  if (v.size() == 6) return PosC{pose_from_rpy({v[0], v[1], v[2]}, {v[3], v[4], v[5]}), true};
  const Robot* robot = of != nullptr ? &model_of(vm, *of) : Host::of(vm).only_robot();
  // Only for an arm in a level plane, whose tool keeps its tilt, three numbers are not a position.
  const bool is_place = v.size() == 3 && (robot == nullptr || !fixed_tilt(*robot));
  const TaskSpace space = robot == nullptr || is_place ? TaskSpace::kOther : task_space(*robot);
  if (v.size() == 3 && space != TaskSpace::kPlane)
    return PosC{make_translation({v[0], v[1], v[2]}), false};
  if (coordinate_count(space) != static_cast<int>(v.size()))
    return fail_posc_count(vm, v.size(), robot, space);
  const auto T = pose_of_coordinates(*robot, v);
  if (!T) {
    return failure(
        vm, "R0609",
        fmt::format("x and y are too close to the axis about which `{}` turns: the plane "
                    "of its tool does not come there",
                    robot->name()),
        at("values"));
  }
  return PosC{*T, space != TaskSpace::kPlanePosition};
}

MoveCall classic_call(std::string_view function, const RobotRef& r) {
  return {.function = function, .robot = r.id, .target = at("p"), .classic = true};
}
Started move_j(Vm& vm, const RobotRef& r, std::string_view planner, const PosJ& p, double time) {
  return move_to_joints(vm, classic_call("moveJ", r), p.vector(), std::string(planner),
                        {.time = time});
}
Started move_c(Vm& vm, const RobotRef& r, std::string_view planner, const PosC& p, double time) {
  const MoveCall call = classic_call("moveC", r);
  if (planner == "Lin") return move_on_line(vm, call, p, {.time = time});
  return move_to_position(vm, call, p, {}, std::string(planner), {.time = time});
}

// A function that always fails before the run, with an explanation.
constexpr NativeFunction refused(std::string_view signature, void (*check)(CheckCall& call)) {
  NativeFunction function = declare(signature, "", "", check);
  function.pauses = true;
  return function;
}

constexpr double kStandInSize = 0.040;  // m

using Eigen::Isometry3d;

// A pose in reach, in front of the robot: straight below its tool at the middle of its joint ranges
// if that is possible, otherwise at half its reach along x.
Isometry3d stand_in_place(const Host& host) {
  const Robot* robot = host.only_robot();
  Isometry3d T = Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(0.3, 0.0, kStandInSize / 2);
  if (robot == nullptr) return T;
  const Eigen::VectorXd middle = 0.5 * (robot->lower() + robot->upper());
  T.translation() = forward(*robot, middle).translation();
  return T;
}

Answer<void> insert_obj(Vm& vm, std::string_view given_name) try {
  Host& host = Host::of(vm);
  const std::string name(given_name);
  if (find_object(vm, name) == nullptr) {
    if (host.has_world()) return fail_unknown_object(vm, name, at("name"));
    Object cube;
    cube.name = name;
    cube.shape = Box{Eigen::Vector3d::Constant(kStandInSize)};
    cube.T_world_obj = stand_in_place(host);
    host.cell().insert(std::move(cube));
    Failure advice;
    advice.headline = {row("W0712"), {name}};
    advice.mark = at("name");
    vm.advise(advice);
  }
  host.cell().add_to_task(name);
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}

Answer<Eigen::Vector3d> get_pos_obj(Vm& vm, std::string_view name) {
  const Object* object = find_object(vm, name);
  if (object == nullptr) return fail_unknown_object(vm, name, at("name"));
  return Eigen::Vector3d(object->T_world_obj.translation());
}
Eigen::VectorXd get_pos_robot(Vm& vm, const RobotRef& r) { return state_of(vm, r).q; }
std::int64_t get_number_obj(Vm& vm) {
  return static_cast<std::int64_t>(Host::of(vm).cell().task_objects().size());
}

constexpr std::string_view kClassicMoveJHelp =
    "Moves the joints to a position with a planner such as 'Syn', in a time (seconds, or with a "
    "unit).";
constexpr std::string_view kMoveCHelp =
    "Moves the hand to a place: 'Lin' in a straight line, other planners with the joints.";

constexpr NativeFunction kClassicFunctions[] = {
    def<posc_from>(
        "posC(values: double[], of: robot?) -> posC",
        "A place (3 numbers), a place with roll, pitch, yaw (6), or as many numbers as the robot "
        "controls; metres and radians. A SCARA controls x, y, z and the rotation about z, an arm "
        "in a level plane x, y and the rotation about z (x, y with two joints), one with five "
        "joints such as the Scorbot x, y, z, pitch and roll: pitch is the angle of the tool's axis "
        "above the horizontal, -90 deg straight down, and roll turns the tool about that axis, "
        "with its y axis horizontal at 0. of: the robot that is meant, where there are several.",
        "posC([0.3, 0.1, 0.2])", {.check = check_posc_list}),
    def<move_j>("moveJ(r: robot, traj: string, p: posJ, time: double | time) -> Move",
                kClassicMoveJHelp, "moveJ('Syn', home(), 2.0); moveJ('Syn', home(), 2s)",
                {.check = check_classic_joints, .pauses = true}),
    def<move_c>("moveC(r: robot, traj: string, p: posC, time: double | time) -> Move", kMoveCHelp,
                "moveC('Lin', here(), 2.0); moveC('Lin', here(), 2s)",
                {.check = check_classic_position, .pauses = true}),
    refused("moveJ(r: robot, traj: string, q: double[], time: double) -> Move",
            explain_list_for_posj),
    refused("moveJ(r: robot, traj: string, q: double[], time: time) -> Move",
            explain_list_for_posj),
    refused("moveC(r: robot, traj: string, q: double[], time: double) -> Move",
            explain_list_for_posj),
    refused("moveC(r: robot, traj: string, q: double[], time: time) -> Move",
            explain_list_for_posj),
    refused("moveC(r: robot, via: posC, goal: posC, time: time?, speed: speed?) -> Move",
            explain_arc),
    def<insert_obj>("insertObj(name: string)", "Makes an object of the world part of the task.",
                    "insertObj(\"cube\")", {.check = check_object_name}),
    def<get_pos_obj>("getPosObj(name: string) -> double[]",
                     "The centre of an object: x, y, z in metres.", "getPosObj(\"cube\")",
                     {.check = check_object_name}),
    def<get_pos_robot>("getPosRobot(r: robot) -> double[]", "The joint values, radians and metres.",
                       "getPosRobot()"),
    def<get_number_obj>("getNumberObj() -> int", "How many objects were made part of the task.",
                        "getNumberObj()"),
};

}  // namespace

std::span<const NativeFunction> classic_functions() { return kClassicFunctions; }

}  // namespace armlet::bind
