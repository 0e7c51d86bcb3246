#pragma once
// An arm as a scene of triangles, as the page draws it, for export to other programs.

#include "armlet/mesh/glb.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// The shapes of link_shapes and the meshes of links that have some, at home. There is a node for
// the base, one for each link (in the frame that moves with its joint, about or along z), one for
// the flange and an empty one at the tool point, each a child of the one before. Round surfaces
// have 32 faces about their axis.
GlbScene robot_scene(const Robot& robot);

}  // namespace armlet
