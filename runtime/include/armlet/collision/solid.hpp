// Bodies and how far they are apart.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "armlet/mesh/triangle_mesh.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/world/object.hpp"

namespace armlet {

// A convex core and all points up to `margin` from it. A ball is a point with a margin, a capsule a
// segment with one. The core lies in the middle of its frame, along z. Meshes lie in theirs as
// their vertices say: a hull is all of a mesh that is convex, a triangle one piece of it, and the
// core kMesh, which alone need not be convex, the set of all its triangles and what they enclose.
//
// half    half the sides of a box, and of the box around a mesh; (radius, radius, half height) of a
//         cylinder and a cone, whose tip is at +z; (0, 0, half length) of a segment. m
// margin  m, >= 0; none of meshes.
// mesh    not owned; null unless the core is one of it.
// T       its frame, in the frame that both bodies of a question share.
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
  // Radius of a ball about the origin of its frame that holds it, m.
  [[nodiscard]] double reach() const;
  // The body has no inside: nothing can be in its way.
  [[nodiscard]] bool is_empty() const { return !(half.maxCoeff() > 0.0) && !(margin > 0.0); }
};

// The shape of an object in its own frame, and that of a part of an arm in the frame of its link. A
// ring counts as the cylinder that it surrounds: an arm fills it.
Solid solid_of(const Shape& shape);
Solid solid_of(const LinkShape& shape);
// The whole mesh, which has to live as long: a hull if it is convex.
Solid solid_of(const TriangleMesh& mesh);

// How two bodies lie to each other.
//
// distance  m, below zero: how far one of them has to be moved at least to free it.
// p_a, p_b  the nearest points of both; of bodies that overlap, the pair of deepest penetration:
//           p_b - p_a is the motion of `a` that frees it.
// away      unit vector: `a` moved along it leaves `b` the quickest way.
struct Gap {
  double distance = 0.0;
  Eigen::Vector3d p_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d away = Eigen::Vector3d::UnitZ();
};

// The distance is right to 1e-9 m, or 1e-9 of itself, where the bodies are apart, and to 1e-7 m or
// 1e-7 of their size where they overlap; there it is never less deep than the truth. The same bits
// on every machine. Of meshes that are not convex (core kMesh) the distance is that of the nearest
// triangles. Where they overlap with something convex, the depth is that of the triangle which is
// deepest in it, towards the outside of the mesh, and at most that of the hull; two such meshes
// overlap as deep as the deepest vertex of one lies in the other. What lies inside of a closed mesh
// overlaps it.
//
// source  E. G. Gilbert, D. W. Johnson, S. S. Keerthi, A fast procedure for computing the distance
//         between complex objects in three-dimensional space, IEEE J. Robotics and Automation 4,
//         1988; G. van den Bergen, Collision Detection in Interactive 3D Environments, 2004,
//         chapter 4.
Gap gap_between(const Solid& a, const Solid& b);

// Of two bodies that overlap so: whether they are free when `a` has moved as far as the gap says,
// so that the depth is all of it. It always is of convex bodies; of meshes that are not, finely cut
// ones for example, it may be a lower bound.
bool is_whole_depth(const Solid& a, const Solid& b, const Gap& gap);

// Whether they are more than `distance` apart, distance >= 0; quicker than gap_between. Never true
// of bodies that are nearer.
bool is_farther(const Solid& a, const Solid& b, double distance);

}  // namespace armlet
