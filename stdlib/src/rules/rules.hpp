#pragma once
// Robot rules checked before the run (language reference, 20.3): joint counts and kinds, planners,
// objects.
//
// Rules use facts: what is known of a robot or a position from the text alone.

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/native.hpp"
#include "armlet/model/dh.hpp"
#include "armlet/model/robot.hpp"

namespace armlet::bind {

// Knowledge about a robot before the run: at least its joints.
struct RobotFact : Fact {
  std::string name;
  std::vector<bool> turns;  // one per joint: true: revolute, false: prismatic
  // Joint limits, one per joint, lower and upper, SI; unknown limits are empty, and the list is
  // empty if none is known.
  std::vector<std::optional<std::array<double, 2>>> limits;
  // If all of it is known; and whether its base or its tool may also be tilted.
  std::shared_ptr<const Robot> model{};
  bool may_be_tilted = false;
};
// A robot whose joints are in a file that is read in the run: its name in the cell.
struct ReadRobotFact : Fact {
  std::string name;
};
struct JointFact : Fact {
  bool turns = true;
  std::optional<std::array<double, 2>> limits;  // if both are known
  Span written;                                 // where the limits are written
  std::optional<DhRow> row;                     // if all of it is known
};
// A frame that is not tilted, or a tool that is not tilted on its flange.
struct UprightFact : Fact {};
// The number of values in a posJ, and the known ones (SI).
struct PositionFact : Fact {
  struct Item {
    std::optional<double> value;
    std::optional<bool> turns;  // true: an angle, false: a length; empty: a plain number
    Span written;
  };
  int count = 0;
  std::vector<Item> items;  // empty if none are known
};

// posJ(90deg, ...), posJ(list) and new posJ(list): E0302, E0401, E0404, W0702.
void check_posj_values(CheckCall& call);
void check_posj_list(CheckCall& call);

// posC(list) and new posC(list), with the setting `of`: the list has as many numbers as the robot
// controls, E0534.
void check_posc_list(CheckCall& call);
// Notes frames and tools without tilt: they do not change which coordinates a robot controls.
void note_upright(CheckCall& call);
// A joint as its row describes it; unknown limits are those of a joint without limits. All else is
// known.
[[nodiscard]] Joint joint_of(const JointFact& fact);
// Notes the model of a robot with these joints. If any of the parameters `may_tilt` is given, the
// base or the tool may be tilted.
void note_model(CheckCall& call, RobotFact& fact, const std::vector<Joint>& joints,
                DhConvention convention, std::initializer_list<CallPart> may_tilt);
// Whether one of these parameters is given that may tilt the base or the tool of a robot.
[[nodiscard]] bool may_be_tilted(const CheckCall& call, std::initializer_list<CallPart> may_tilt);

// W0702: radians that look like degrees, in a list of joint values known from the text.
void advise_degrees(CheckCall& call, CallPart part, const std::vector<Constant>& items,
                    const RobotFact* robot);
// Reports W0702 for a parameter that takes joint values as a list.
template <ParameterName kName>
void check_joint_list(CheckCall& call);

// The robot that a call without a robot uses; for a call with one, its first parameter.
[[nodiscard]] std::shared_ptr<const RobotFact> ambient_robot(const CheckCall& call);
[[nodiscard]] std::shared_ptr<const RobotFact> robot_of(const CheckCall& call);

// Robots and their parts: E0508 to E0511.
void check_revolute_row(CheckCall& call);
void check_prismatic_row(CheckCall& call);
void check_robot_block(CheckCall& call);
void check_dh_table(CheckCall& call);
void check_ready_robot(CheckCall& call);
void check_default_robot(CheckCall& call);
void set_robot_fact(CheckCall& call, std::shared_ptr<const Robot> robot, std::string name,
                    std::initializer_list<CallPart> may_tilt = {});

// E0534: known joint values that are beyond known limits.
void check_joint_values(CheckCall& call, const RobotFact& robot, const PositionFact& position,
                        Span used);
// Reports E0534 for a parameter, a posJ or a list of them, of a call whose first parameter is the
// robot.
void check_joint_limits(CheckCall& call, CallPart part);
// Reports E0534 for a posJ, and E0302 for a wrong number of values.
void check_joint_target(CheckCall& call, CallPart part);
template <ParameterName kName>
void check_joints_of(CheckCall& call) {
  check_joint_target(call, kPart<kName>);
}

// Moves.
void check_move_joints(CheckCall& call);       // to a posJ
void check_move_position(CheckCall& call);     // to a posC
void check_classic_joints(CheckCall& call);    // moveJ(traj, posJ, time)
void check_classic_position(CheckCall& call);  // moveJ(traj, posC, time)
void check_move_line(CheckCall& call);
// Parts of these rules: an unknown planner, and a time together with a speed.
void check_planner(CheckCall& call, CallPart part);
void check_time_and_speed(CheckCall& call);
// The edit that removes a setting; empty if no comma precedes it.
[[nodiscard]] std::vector<Edit> without(const CheckCall& call, CallPart part);
// A negative duration in the text: E0513.
void check_duration(CheckCall& call, CallPart part);
void check_arc(CheckCall& call);     // (r, via, target, time, speed, blend)
void check_spline(CheckCall& call);  // (r, points, time, traj, speed)
// The settings time, tool and blend of a move, which have a meaning only in a path, or only outside
// of one: E0502, E0514.
enum class TakesTool { kNo, kYes };
void check_in_path(CheckCall& call, TakesTool takes_tool);
void check_joints_in_path(CheckCall& call);  // also speed, accel and traj
// A length given to `path` or in it: E0513.
void check_blend(CheckCall& call, CallPart part);
// (name, points, time, durations, speed, accel), after the robot or without it.
template <bool kRobotFirst>
void check_trajectory(CheckCall& call);
void check_plan(CheckCall& call);  // (r, to, time, speed, ...)
// Calls that exist only to explain a mistake.
void explain_list_for_posj(CheckCall& call);  // E0301: moveJ("Syn", q, 2.0) with a double[]
void explain_arc(CheckCall& call);            // E0503: moveC(via, goal, ...)

// Every parameter is a length of a shape: E0513.
void check_box(CheckCall& call);
void check_cylinder(CheckCall& call);
void check_plane(CheckCall& call);
void check_sphere(CheckCall& call);
// The first parameter is an object's name: E0203.
void check_object_name(CheckCall& call);

// Joint values in parameter `part` of a call whose first parameter is the robot.
void check_list_of_joints(CheckCall& call, CallPart part);

// A list with a number for each joint, in a call whose first parameter is the robot: its numbers
// get their units as soon as the joints of the robot are known, before or in the run (DimsFact).
void note_positions(CheckCall& call);
// The result has the same numbers as the first argument.
void note_same_numbers(CheckCall& call);
void note_read_robot(CheckCall& call);
// The text NumberDim::later for numbers of joints: the units for revolute and prismatic joints, and
// the robot.
std::string dims_by_joint(std::string_view turning, std::string_view sliding,
                          std::string_view robot);
void note_speeds(CheckCall& call);
void note_accels(CheckCall& call);
void note_forces(CheckCall& call);
// A table with a row (theta, d, a, alpha) for each joint.
void note_dh_table(CheckCall& call);
// Three numbers along the axes and three about them: tcpSpeed, jacobianDot.
void note_twist(CheckCall& call);
void note_twist_rate(CheckCall& call);

// The result is a motion of the robot in parameter `kName`, or of the motion there, so that numbers
// for its joints have units.
template <ParameterName kName>
void note_motion_of(CheckCall& call) {
  const bool is_given = call.given(kPart<kName>);
  auto known = is_given ? call.fact(kPart<kName>) : nullptr;
  if (!is_given && kPart<kName> == at("r")) known = call.ambient_fact("robot");
  if (known != nullptr) call.set_result_fact(std::move(known));
}

// Several rules, one after the other.
template <void (*... kRules)(CheckCall&)>
void check_all_of(CheckCall& call) {
  (kRules(call), ...);
}

template <ParameterName kName>
void check_joint_list(CheckCall& call) {
  check_list_of_joints(call, kPart<kName>);
}

}  // namespace armlet::bind
