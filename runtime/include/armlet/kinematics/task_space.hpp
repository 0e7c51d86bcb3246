#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string_view>

#include "armlet/model/robot.hpp"

namespace armlet {

// The coordinates of the tool that an arm can set independently, in their order.
//
// kPose       x, y, z, roll, pitch, yaw: any pose. Six joints or more.
// kPitchRoll  x, y, z, pitch, roll: five joints; the first rotates about the vertical and the
//             others keep the tool's axis in a vertical plane, as in a Scorbot.
// kPitch      x, y, z, pitch: the same with four joints.
// kHeading    x, y, z and the rotation about z: a SCARA.
// kPosition   x, y, z.
// kPlane      x, y and the rotation about z: an arm that moves in a level plane.
// kPlanePosition  x, y: such an arm with two joints.
// kOther      none of these.
//
// Coordinates are those of the world. `pitch` is the angle of the tool's z axis above the
// horizontal, positive upwards: -90 deg points straight down. `roll` rotates the tool about that
// axis; at 0 the tool's y axis is horizontal, along z_world x (direction of the arm).
enum class TaskSpace {
  kPose,
  kPitchRoll,
  kPitch,
  kHeading,
  kPosition,
  kPlane,
  kPlanePosition,
  kOther
};

// Number of coordinates, and their names: 5 and "x, y, z, pitch and roll". 0 and "" for kOther.
int coordinate_count(TaskSpace space);
std::string_view coordinate_names(TaskSpace space);

// Found from the Jacobians at joint values spread over their ranges; stored with the robot.
TaskSpace task_space(const Robot& robot);

// The pose of the tool for given coordinates. What they do not determine is a constant of the arm:
// the height of its plane, the tilt of its tool. An arm with a pitch reaches forwards from its
// vertical axis; on that axis it reaches along x.
//
// values   one for each coordinate of task_space(robot), m and rad.
// returns  T_world_tool; nothing for kOther, another number of values, or a point nearer to the
//          vertical axis than the tool can get.
std::optional<Eigen::Isometry3d> pose_of_coordinates(const Robot& robot,
                                                     std::span<const double> values);

}  // namespace armlet
