#pragma once

#include "armlet/model/mechanism.hpp"

namespace armlet {

// The rigid body of a link in another frame; the motor is left out.
Link moved(const Link& link, const Eigen::Isometry3d& T_to_from);

// Adds a rigid body that is fixed to a link and given in its frame.
void add_body(Link& link, const Link& body);

// Copies the motor and its friction.
void copy_motor(Link& to, const Link& from);

// The motion of a body by a value of its joint, after T_parent_joint.
Eigen::Isometry3d joint_motion(const Body& body, double value);

}  // namespace armlet
