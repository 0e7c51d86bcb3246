#pragma once

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"
#include "armlet/model/urdf.hpp"

namespace armlet {

// An arm as a mechanism: the base is the link "world"; then one link for each joint ("link1" ...),
// "flange" and "tool", which is also a tip. The frame of a link is the one that its joint moves, so
// inertias are transformed to it from the Denavit-Hartenberg frames. Mimic joints stay mimic
// joints.
MechanismSpec mechanism_of(const Robot& robot);

// The chain of joints from the base to a link or tip as an arm in the modified convention, its base
// the root link. A mimic joint of the chain becomes a row with a drive (Joint::drive): its source
// joint gets its motor and friction, and limits that keep it within its own, unless none are left.
// Links outside of the chain that mimic joints of the chain move are kept (RobotSpec::followers);
// other links count as fixed at the zero of their joints.
//
// tip      name of a link or tip; empty: the end of the only chain, or of the longest one if all
//          joints of the others are mimic joints, which RobotSpec::notes reports.
// returns  in rad and m; an error naming the joint or the choices if there is no such chain, if a
//          joint of it has several actuators or none, or it has not 1 to kMaxJoints joints.
// source   J. Denavit and R. Hartenberg 1955: common normals of the axes; two axes within 1e-8 rad
//          of parallel count as parallel.
Result<RobotSpec> serial_arm(const Mechanism& mechanism, std::string_view tip = {});

// The serial arm of a robot description.
//
// returns  an error as read_urdf and serial_arm.
Result<RobotSpec> serial_arm_of_urdf(std::string_view text, const UrdfOptions& options,
                                     std::string_view tip = {});

}  // namespace armlet
