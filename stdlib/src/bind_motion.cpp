// Moves (language reference, 13.2 and 19.4).

#include <optional>

#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "moves.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

std::optional<double> given(Slot s) {
  return is_absent(s) ? std::nullopt : std::optional<double>(s.d);
}

// (r, target, time, speed, accel, traj, near)
Signal move_j_joints(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveJ", .robot = host_value<RobotRef>(args[0]).id};
  return move_to_joints(vm, args, call, posj(args[1]).vector(), std::string(text_value(args[5])),
                        given(args[2]), given(args[3]));
}

Signal move_j_place(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveJ", .robot = host_value<RobotRef>(args[0]).id};
  const Eigen::VectorXd seed =
      args[6].o != nullptr ? posj(args[6]).vector() : Host::of(vm).cell().robot(call.robot).q;
  const auto q = solve_target(vm, call, posc(args[1]), seed);
  if (!q) return Signal::kFail;
  return move_to_joints(vm, args, call, *q, std::string(text_value(args[5])), given(args[2]),
                        given(args[3]));
}

// (r, target, time, speed, accel, tool, frame, blend)
Signal move_l(Vm& vm, Slot* args) {
  const MoveCall call{.function = "moveL", .robot = host_value<RobotRef>(args[0]).id};
  return move_on_line(vm, args, call, posc(args[1]), given(args[2]), given(args[3]));
}

Signal set_joints(Vm& vm, Slot* args) {
  Host& host = Host::of(vm);
  const int id = host_value<RobotRef>(args[0]).id;
  const CellRobot& robot = host.cell().robot(id);
  const Eigen::VectorXd q = posj(args[1]).vector();
  if (q.size() != robot.model->n())
    return size_failure(vm, "setJoints", static_cast<std::size_t>(q.size()),
                        static_cast<std::size_t>(robot.model->n()));
  const MoveCall call{.function = "setJoints", .robot = id};
  if (const auto outside = limit_violations(*robot.model, q); !outside.empty())
    return fail_outside(vm, call, q, outside.front());
  if (refuse_busy(vm, id)) return Signal::kFail;
  host.cell().set_joints(id, q);
  return give_nothing();
}

constexpr std::string_view kMoveJHelp =
    "Moves all joints together; to a position in space, its inverse kinematics is solved first. "
    "time or speed, not both; neither means as fast as the joints allow.";

constexpr NativeFunction kFunctions[] = {
    {"moveJ",
     "(r: robot, target: posJ, time: time?, speed: double?, accel: accel?, traj: string = \"Syn\", "
     "near: posJ?) -> Move",
     kMoveJHelp, "moveJ(home(), time: 2s)", move_j_joints, nullptr, nullptr, check_move_joints,
     nullptr, true},
    {"moveJ",
     "(r: robot, target: posC, time: time?, speed: double?, accel: accel?, traj: string = \"Syn\", "
     "near: posJ?) -> Move",
     kMoveJHelp, "moveJ(here(), time: 1s)", move_j_place, nullptr, nullptr, check_move_place,
     nullptr, true},
    {"moveL",
     "(r: robot, target: posC, time: time?, speed: speed?, accel: accel?, tool: posC?, frame: "
     "posC?, blend: length?) -> Move",
     "Moves the hand along a straight line; the orientation turns evenly. time or speed, not both; "
     "neither means as fast as the joints allow.",
     "moveL(here(), speed: 80mm/s)", move_l, nullptr, nullptr, check_move_line, nullptr, true},
    commanding({"setJoints", "(r: robot, q: posJ)",
                "Puts a simulated robot into a position without moving it.", "setJoints(home())",
                set_joints}),
};

}  // namespace

std::span<const NativeFunction> motion_functions() { return kFunctions; }

}  // namespace armlet::bind
