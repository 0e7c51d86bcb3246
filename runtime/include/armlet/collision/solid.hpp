// Bodies and the distances between them.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "armlet/mesh/triangle_mesh.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/world/object.hpp"

namespace armlet {

// A convex core and all points up to `margin` from it. A ball is a point with a margin, a capsule a
// segment with one. The core is centred in its frame, along z. Meshes are positioned by their
// vertices: a hull is the whole of a convex mesh, a triangle one part of a mesh, and the core
// kMesh, the only one that need not be convex, the set of all triangles and the volume that they
// enclose.
//
// half    half the sides of a box, and of the bounding box of a mesh; (radius, radius, half height)
//         of a cylinder and a cone, whose tip is at +z; (0, 0, half length) of a segment. m
// margin  m, >= 0; 0 for meshes.
// mesh    not owned; null unless the core is a mesh or a part of one.
// T       its frame, in the common frame of the two compared bodies.
struct Solid {
  enum class Core : std::uint8_t {
    kPoint,
    kSegment,
    kBox,
    kCylinder,
    kCone,
    kHull,
    kTriangle,
    kMesh
  };
  Core core = Core::kPoint;
  std::uint32_t triangle = 0;
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
  double margin = 0.0;
  const TriangleMesh* mesh = nullptr;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();

  [[nodiscard]] bool is_convex() const { return core != Core::kMesh; }
  // Radius of the smallest ball about the origin of its frame that contains it, m.
  [[nodiscard]] double reach() const;
  // Whether the body has no points: it cannot collide.
  [[nodiscard]] bool is_empty() const { return !(half.maxCoeff() > 0.0) && !(margin > 0.0); }
};

// The shape of an object in its own frame, and that of a part of an arm in the frame of its link. A
// ring counts as the cylinder that it surrounds, since the arm fills it.
Solid solid_of(const Shape& shape);
Solid solid_of(const LinkShape& shape);
// The whole mesh, which has to live as long; a hull if it is convex.
Solid solid_of(const TriangleMesh& mesh);

// The distance between two bodies.
//
// distance  m; if they overlap, minus the length of the smallest displacement that separates them.
// p_a, p_b  the nearest points of both; of bodies that overlap, the pair of deepest penetration:
//           p_b - p_a is the displacement of `a` that separates them.
// away      unit vector: the direction in which `a` leaves `b` by the shortest displacement.
struct Gap {
  double distance = 0.0;
  Eigen::Vector3d p_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d away = Eigen::Vector3d::UnitZ();
};

// The distance is exact to 1e-9 m, or 1e-9 of itself, where the bodies are apart, and to 1e-7 m or
// 1e-7 of their size where they overlap; there the depth is never underestimated. The same bits on
// every machine. For meshes that are not convex (core kMesh) the distance is that of the nearest
// triangles. Where one overlaps with a convex body, the depth is that of the triangle which is
// deepest in it, towards the outside of the mesh, and at most that of the hull; for two such meshes
// it is the depth of the deepest vertex of one in the other. A body inside a closed mesh overlaps
// it.
//
// source  E. G. Gilbert, D. W. Johnson, S. S. Keerthi, A fast procedure for computing the distance
//         between complex objects in three-dimensional space, IEEE J. Robotics and Automation 4,
//         1988; G. van den Bergen, Collision Detection in Interactive 3D Environments, 2004,
//         chapter 4.
Gap gap_between(const Solid& a, const Solid& b);

// For two overlapping bodies with this gap: whether they are separate when `a` has moved as far as
// the gap says, so that the depth is the whole one. This is always true of convex bodies; for other
// meshes, for example finely divided ones, the depth may be a lower bound.
bool is_whole_depth(const Solid& a, const Solid& b, const Gap& gap);

// Whether they are more than `distance` apart, distance >= 0; faster than gap_between. Never true
// for bodies that are nearer.
bool is_farther(const Solid& a, const Solid& b, double distance);

}  // namespace armlet
