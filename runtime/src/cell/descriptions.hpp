#pragma once
// Event data of robots and objects for backends.

#include "armlet/backend/event.hpp"
#include "armlet/cell/cell.hpp"

namespace armlet {

RobotInfo robot_info(const CellRobot& robot);
ObjectInfo object_info(const Object& object);
DrawingInfo drawing_info(const Drawing& drawing);
CameraInfo camera_info(const Camera& camera);

}  // namespace armlet
