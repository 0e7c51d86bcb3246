#pragma once
// Robot rules checked before running (language reference, 20.3): joint counts and kinds, planners,
// objects.
//
// Rules work on facts: what the text alone tells about a robot or a position.

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

// What is known of a robot before running: at least its joints.
struct RobotFact : Fact {
  std::string name;
  std::vector<bool> turns;  // one per joint: true turns, false slides
  // One per joint, lower and upper, SI; those that the text does not show are empty, and so is the
  // list if it shows none.
  std::vector<std::optional<std::array<double, 2>>> limits;
  // Where the text shows all of it; whether its base or its tool may be tilted besides.
  std::shared_ptr<const Robot> model{};
  bool may_be_tilted = false;
};
// Of one whose joints stand in a file that is read in the run: its name in the cell.
struct ReadRobotFact : Fact {
  std::string name;
};
struct JointFact : Fact {
  bool turns = true;
  std::optional<std::array<double, 2>> limits;  // where the text shows both
  Span written;                                 // of the limits
  std::optional<DhRow> row;                     // where the text shows all of it
};
// A frame that is not tilted, and a tool that is not tilted on its flange.
struct UprightFact : Fact {};
// How many values a posJ holds, and those that the text shows (SI).
struct PositionFact : Fact {
  struct Item {
    std::optional<double> value;
    std::optional<bool> turns;  // an angle, not a length; empty for a plain number
    Span written;
  };
  int count = 0;
  std::vector<Item> items;  // empty if the text shows none
};

// posJ(90deg, ...), posJ(list) and new posJ(list): E0302, E0401, E0404, W0702.
void check_posj_values(CheckCall& call);
void check_posj_list(CheckCall& call);

// posC(list) and new posC(list), with the setting `of`: as many numbers as the robot controls,
// E0534.
void check_posc_list(CheckCall& call);
// What leaves the coordinates that a robot controls as they are: frames and tools without a tilt.
void note_upright(CheckCall& call);
// A joint as its row shows it, which is known; with the limits of the text, or those of a joint
// without any.
[[nodiscard]] Joint joint_of(const JointFact& fact);
// The model of a robot with these joints, of which any parameter of `may_tilt` that is given may
// tilt the base or the tool.
void note_model(CheckCall& call, RobotFact& fact, const std::vector<Joint>& joints,
                DhConvention convention, std::initializer_list<int> may_tilt);
// Whether a parameter that is given may tilt the base or the tool of a robot.
[[nodiscard]] bool may_be_tilted(const CheckCall& call, std::initializer_list<int> may_tilt);

// W0702: radians that look like degrees, in a list of joint values that is known from the text.
void advise_degrees(CheckCall& call, int parameter, const std::vector<Constant>& items,
                    const RobotFact* robot);
// The same for a parameter that takes joint values as a list.
template <int kParameter>
void check_joint_list(CheckCall& call);

// The robot that a call without a robot uses, and that of a call whose first parameter is one.
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
                    std::initializer_list<int> may_tilt = {});

// E0534: joint values that the text shows, beyond limits that it shows too.
void check_joint_values(CheckCall& call, const RobotFact& robot, const PositionFact& position,
                        Span used);
// Of the parameter of a call whose first one is the robot: a posJ, or a list of them.
void check_joint_limits(CheckCall& call, int parameter);
// The same of a posJ, with their number: E0302.
void check_joint_target(CheckCall& call, int parameter);
template <int kParameter>
void check_joints_of(CheckCall& call) {
  check_joint_target(call, kParameter);
}

// Moves. The parameters stand in the order of the signatures they are used in.
void check_move_joints(CheckCall& call);       // (r, target: posJ, ..., traj: string)
void check_move_position(CheckCall& call);     // (r, target: posC, ..., traj: string)
void check_classic_joints(CheckCall& call);    // (r, traj, posJ, time)
void check_classic_position(CheckCall& call);  // (r, traj, posC, time)
void check_move_line(CheckCall& call);  // (r, target, time, speed, accel, tool, frame, blend)
// Two parts of them: a planner that is not known, and a time together with a speed.
void check_planner(CheckCall& call, int parameter);
void check_time_and_speed(CheckCall& call, int time, int speed);
// The edit that leaves a setting out; empty where it is not behind a comma.
[[nodiscard]] std::vector<Edit> without(const CheckCall& call, int parameter);
// A duration that the text shows to be below zero: E0513.
void check_duration(CheckCall& call, int parameter);
void check_arc(CheckCall& call);     // (r, via, target, time, speed, blend)
void check_spline(CheckCall& call);  // (r, points, time, traj, speed)
// The settings of a move that mean something only in a path, or only outside: E0502, E0514. -1: the
// move has no such setting.
struct PathParameters {
  int time = -1;
  int tool = -1;
  int blend = -1;
};
void check_in_path(CheckCall& call, const PathParameters& parameters);
void check_joints_in_path(CheckCall& call,
                          int blend);  // (r, target, time, speed, accel, traj, ...)
// A length given to `path` or in it: E0513.
void check_blend(CheckCall& call, int parameter);
// (name, points, time, durations, speed, accel), behind the robot or not.
template <bool kRobotFirst>
void check_trajectory(CheckCall& call);
void check_plan(CheckCall& call);  // (r, to, time, speed, ...)
// Calls that exist only to be explained.
void explain_list_for_posj(CheckCall& call);  // E0301: moveJ("Syn", q, 2.0) with a double[]
void explain_arc(CheckCall& call);            // E0503: moveC(via, goal, ...)

// Every parameter is a length of a shape: E0513.
void check_box(CheckCall& call);
void check_cylinder(CheckCall& call);
void check_plane(CheckCall& call);
void check_sphere(CheckCall& call);
// The first parameter is an object's name: E0203.
void check_object_name(CheckCall& call);

// Joint values in parameter `parameter`, of a call whose first one is the robot.
void check_list_of_joints(CheckCall& call, int parameter);

// What a list with a number for each joint holds, of a call whose first parameter is the robot:
// its numbers get their units where the robot's joints are known, then or in the run (DimsFact).
void note_positions(CheckCall& call);
// The numbers of the first argument, one by one.
void note_same_numbers(CheckCall& call);
void note_read_robot(CheckCall& call);
// NumberDim::later of numbers for each joint: units for those that turn and slide, and whose they
// are.
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

// A motion knows the robot in parameter `kParameter`, or the motion there that it is made of, so
// that numbers for its joints have units.
template <int kParameter>
void note_motion_of(CheckCall& call) {
  const bool is_given = call.given(kParameter);
  auto known = is_given ? call.fact(kParameter) : nullptr;
  if (!is_given && kParameter == 0) known = call.ambient_fact("robot");
  if (known != nullptr) call.set_result_fact(std::move(known));
}

// Several rules, one after the other.
template <void (*... kRules)(CheckCall&)>
void check_all_of(CheckCall& call) {
  (kRules(call), ...);
}

template <int kParameter>
void check_joint_list(CheckCall& call) {
  check_list_of_joints(call, kParameter);
}

}  // namespace armlet::bind
