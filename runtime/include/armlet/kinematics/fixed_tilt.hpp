#pragma once

#include <optional>

#include "armlet/kinematics/ik.hpp"

namespace armlet {

// The world's z axis in the axes of the tool, if it is the same for all joint values: all revolute
// joints rotate about vertical axes, as in a SCARA or a gantry. Its length is 1; nothing for other
// arms.
//
// The arm reaches an orientation R_world_tool only if its third row is this axis, because e_z^T
// Rz(psi) = e_z^T for every psi.
std::optional<Eigen::Vector3d> fixed_tilt(const Robot& robot);

// The task that a frame sets for an arm: the whole pose; or, if tool and frame are both vertical
// for all joint values, the position and the rotation about z, whichever of the two points down.
//
// T_world_frame  the frame, in the world.
// returns        kPose or kHeading; nothing if no joint values tilt the tool like the frame, to
//                1e-6 rad.
std::optional<IkTask> frame_task(const Robot& robot, const Eigen::Isometry3d& T_world_frame);

// The angle between the z axes of a frame and of the tool, for an arm with a fixed tilt, rad; 0 for
// other arms. T_world_frame as above.
double tilt_error(const Robot& robot, const Eigen::Isometry3d& T_world_frame);

// The tool pose of a frame under IkTask::kHeading: position and rotation about z are those of the
// frame, the tilt is that of the tool at q.
//
// q        n joint values, rad or m.
// returns  the pose T_world_tool.
// throws   ArgumentError unless q has n finite elements.
Eigen::Isometry3d with_heading_of(const Robot& robot, const Eigen::Isometry3d& T_world_frame,
                                  JointsIn q);

}  // namespace armlet
