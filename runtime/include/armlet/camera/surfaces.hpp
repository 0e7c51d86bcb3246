#pragma once
// Surfaces of the bodies of a cell, as a camera sees them.

#include <vector>

#include "armlet/camera/scene.hpp"
#include "armlet/mesh/glb.hpp"
#include "armlet/world/object.hpp"

namespace armlet {

// The material of the part of a surface that shows the picture of an object: the upper face of a
// box, the round side of a cylinder, all of the other shapes. The rest has material 0.
inline constexpr std::uint8_t kPicturedMaterial = 1;

// The surface of an object in its own frame. Round shapes are smooth, of 48 faces about their axis.
// Pictures lie upright, seen from outside; on the upper face of a box and on a plane with their
// right side along x and their upper side along y.
//
// Features are the eight corners of a box: those of the upper face first, counterclockwise from
// (-x, -y) of its own frame, then those below; the four of a plane alike; the apex of a cone;
// otherwise none.
//
// throws  ArgumentError for a mesh without triangles.
Surface surface_of(const Shape& shape);

// Parts of a node of a scene, each material under its own number of the scene.
//
// throws  ArgumentError as Surface, and for a material above 255.
Surface surface_of(const std::vector<GlbPart>& parts, bool closed = true);

// A body for each node of a scene that has triangles, where the node is, with the colours of its
// materials. Pictures are left out: they have to be read first.
//
// throws  ArgumentError as surface_of, and for a parent that does not come before its node.
std::vector<SceneBody> bodies_of(const GlbScene& scene);

}  // namespace armlet
