#pragma once
// Surfaces of the bodies of a cell, as a camera sees them.

#include <vector>

#include "armlet/camera/scene.hpp"
#include "armlet/mesh/glb.hpp"
#include "armlet/world/object.hpp"

namespace armlet {

// The material of the part of a surface on which the texture of an object is drawn: the upper face
// of a box, the round side of a cylinder, all of the other shapes. The rest has material 0.
inline constexpr std::uint8_t kPicturedMaterial = 1;

// The surface of an object in its own frame. Round shapes are smooth, with 48 faces about their
// axis. Textures are upright, seen from outside; on the upper face of a box and on a plane their
// right side is along x and their upper side along y.
//
// Features are the eight corners of a box: those of the upper face first, counterclockwise from
// (-x, -y) of its own frame, then those below; the four of a plane alike; the apex of a cone;
// otherwise none.
//
// throws  ArgumentError for a mesh without triangles.
Surface surface_of(const Shape& shape);

// The surface of a node of a scene; materials keep their numbers of the scene.
//
// throws  ArgumentError as Surface, and for a material above 255.
Surface surface_of(const std::vector<GlbPart>& parts, bool closed = true);

// A body for each node of a scene that has triangles, at the pose of the node, with the colours of
// its materials. Textures are left out, since their files have to be read first.
//
// throws  ArgumentError as surface_of, and for a parent that does not come before its node.
std::vector<SceneBody> bodies_of(const GlbScene& scene);

}  // namespace armlet
