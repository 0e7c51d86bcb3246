#pragma once

#include <optional>

#include "armlet/kinematics/ik.hpp"

namespace armlet {

// The world's z axis in the axes of the tool, if no joint changes it: every joint that turns does
// so about a vertical axis, as in a SCARA or a gantry. Its length is 1; nothing for other arms.
//
// The arm reaches those orientations R_world_tool alone whose third row is this axis, because
// e_z^T Rz(psi) = e_z^T for every psi.
std::optional<Eigen::Vector3d> fixed_tilt(const Robot& robot);

// What a frame asks of an arm: the whole pose; or, where tool and frame are both vertical and no
// joint changes that, the position and the rotation about z, whichever of the two points down.
//
// T_world_frame  the frame, in the world.
// returns        kPose or kHeading; nothing if no joint values whatever lean the tool like the
//                frame, to 1e-6 rad.
std::optional<IkTask> frame_task(const Robot& robot, const Eigen::Isometry3d& T_world_frame);

// How far the frame leans away from the tool of an arm that cannot change it: the angle between the
// two vertical axes, rad; 0 for other arms. T_world_frame as above.
double tilt_error(const Robot& robot, const Eigen::Isometry3d& T_world_frame);

// The pose of the tool that a frame means with IkTask::kHeading: the position and the rotation
// about z of the frame, with the tilt that the tool has at q.
//
// q        n joint values, rad or m.
// returns  the pose T_world_tool.
// throws   ArgumentError unless q has n finite elements.
Eigen::Isometry3d with_heading_of(const Robot& robot, const Eigen::Isometry3d& T_world_frame,
                                  JointsIn q);

}  // namespace armlet
