#pragma once

#include <span>
#include <string>

#include "armlet/model/robot.hpp"

namespace armlet {

// All throw ArgumentError with a sentence that names the joint or link, from 1.
void check_joints(const RobotSpec& spec);
void check_links(const RobotSpec& spec);   // one link per row
void check_drives(const RobotSpec& spec);  // Joint::drive, after the links
void check_payload(const RobotSpec& spec);
// rows  that the joints move.
void check_home(const RobotSpec& spec, std::span<const int> rows);
void check_link_pairs(const RobotSpec& spec);  // RobotSpec::allow and watch

// The error in the mass, the inertia or the motor of a link, as the end of a sentence that begins
// with its name; empty if there is none.
std::string link_fault(const Link& link, InertiaCheck check);

}  // namespace armlet
