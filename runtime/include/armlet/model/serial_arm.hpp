#pragma once

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"
#include "armlet/model/urdf.hpp"

namespace armlet {

// An arm as a mechanism: the base on the link "world", one link for each joint ("link1" ...), then
// "flange" and "tool", which is also a tip. A link's frame is the one that its joint turns, so that
// inertias move from the Denavit-Hartenberg frames to it. Rows that copy others are joints that
// copy joints.
MechanismSpec mechanism_of(const Robot& robot);

// The chain of joints from the base to a link or tip as an arm in the modified convention, its base
// the root link. A joint of the chain that copies another one becomes a row that copies
// (Joint::drive): the joint that it copies gets its motor and friction, and keeps within its limits
// unless these leave none. Links that hang on the chain without belonging to it move as far as
// their joints copy joints of the chain (RobotSpec::followers); otherwise they count as fixed at
// the zero of their joints.
//
// tip      name of a link or tip; empty: the end of the only chain, or of the longest of those that
//          divide if the joints of the others copy joints, which RobotSpec::notes says.
// returns  in rad and m; an error naming the joint or the choices if there is no such chain, if
//          several motors move one joint of it, or none, or it has not 1 to kMaxJoints joints.
// source   J. Denavit and R. Hartenberg 1955: common normals of the axes; two axes within 1e-8 rad
//          of parallel count as parallel.
Result<RobotSpec> serial_arm(const Mechanism& mechanism, std::string_view tip = {});

// The same of a robot description.
//
// returns  an error as read_urdf and serial_arm.
Result<RobotSpec> serial_arm_of_urdf(std::string_view text, const UrdfOptions& options,
                                     std::string_view tip = {});

}  // namespace armlet
