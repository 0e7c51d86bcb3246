#pragma once
// Shapes of links that a robot block describes.

#include "armlet/interpreter/define.hpp"
#include "armlet/model/robot.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Adds the shapes in the rows of a block to the links. Returns whether a link other than the base
// has one.
// throws  ArgumentError for a link or a mesh that does not exist.
Answer<bool> add_bodies(Vm& vm, HostList<BodyRow> rows, RobotSpec& spec);

}  // namespace armlet::bind
