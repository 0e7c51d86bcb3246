// Bodies with a surface of triangles.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

using Corners = std::array<std::uint32_t, 3>;

inline constexpr std::size_t kMostTriangles = 1'000'000;

// Mass properties of a body of density 1: volume, m^3, centre of mass, m, and inertia about it in
// the axes of the mesh, m^5. Multiplied by a density in kg/m^3 they are kg and kg m^2.
struct MassProperties {
  double volume = 0.0;
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

// A tree of bounding boxes. A node's first child follows it, the second is `second`; leaves have
// none (0) and contain the triangles order[begin] to order[end - 1].
struct TriangleTree {
  struct Node {
    Eigen::Vector3d low, high;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t second = 0;
  };
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;
};

// The GLB file that a mesh was read from, for drawing with its materials.
//
// bytes        shared by all meshes that were made from them; null: the mesh has another origin.
// T_mesh_file  from the coordinates of the file, z up, to those of the mesh.
struct MeshSource {
  std::shared_ptr<const std::string> bytes;
  Eigen::Affine3d T_mesh_file = Eigen::Affine3d::Identity();
};

// Triangles, counterclockwise seen from outside. Corners at the same position are merged, and
// triangles without three different corners are removed. The same bits on every machine.
class TriangleMesh {
 public:
  // vertices  m.
  // throws    ArgumentError with the error: no triangles, more than kMostTriangles, an index
  //           without a vertex, a coordinate that is not finite or beyond 10 km.
  TriangleMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Corners> triangles);

  [[nodiscard]] const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
  [[nodiscard]] const Eigen::Vector3d& corner(std::size_t triangle, std::size_t k) const {
    return vertices_[triangles_[triangle][k]];
  }

  // The bounding box.
  [[nodiscard]] const Eigen::Vector3d& low() const { return tree_.nodes.front().low; }
  [[nodiscard]] const Eigen::Vector3d& high() const { return tree_.nodes.front().high; }
  // Radius of the smallest ball about the origin that contains it, m.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }

  // Why it is not the closed surface of a body, as a sentence without a full stop; empty if it is
  // one: every edge is used as often in one direction as in the other. The constructor reverses the
  // triangles of a surface that is inside out, and of a closed part of it that is in no other part.
  [[nodiscard]] const std::string& open_because() const { return open_because_; }
  [[nodiscard]] bool is_closed() const { return open_because_.empty(); }
  // Why its volume counts some regions more than once, as a sentence without a full stop; empty if
  // it does not: closed parts overlap, or are inside one another without being cavities; or there
  // are too many parts to check.
  [[nodiscard]] const std::string& doubled_because() const { return doubled_because_; }
  // Whether it is closed, in one piece, without a hole through it, and convex at every edge.
  [[nodiscard]] bool is_convex() const { return is_convex_; }

  // Mass properties of a closed surface; nothing if it is open. Parts inside one another all count.
  //
  // source  divergence theorem over signed tetrahedra: S. Lien, J. T. Kajiya, A symbolic method for
  //         calculating the integral properties of arbitrary nonconvex polyhedra, IEEE Computer
  //         Graphics and Applications 4, 1984.
  [[nodiscard]] const std::optional<MassProperties>& mass_properties() const { return mass_; }

  // The vertex that is farthest in direction d.
  [[nodiscard]] const Eigen::Vector3d& farthest(const Eigen::Vector3d& d) const;
  // Whether a point is inside a closed surface; false on the surface, and for an open one.
  [[nodiscard]] bool holds(const Eigen::Vector3d& p) const;

  // Its source file; meshes made from it by `scaled` and `moved` keep it.
  [[nodiscard]] const MeshSource& source() const { return source_; }
  void set_source(std::shared_ptr<const std::string> glb) { source_ = {.bytes = std::move(glb)}; }

  // The mesh, scaled along each axis; the orientation of mirrored triangles is corrected.
  //
  // throws  ArgumentError as the constructor.
  [[nodiscard]] TriangleMesh scaled(const Eigen::Vector3d& factors) const;
  // The mesh, moved.
  [[nodiscard]] TriangleMesh moved(const Eigen::Isometry3d& T) const;

 private:
  void drop_doubles();
  void look_at_edges();
  void weigh();
  void set_shells_right();
  void turn_inside_out();

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Corners> triangles_;
  TriangleTree tree_;
  double reach_ = 0.0;
  std::string open_because_;
  std::string doubled_because_;
  bool is_convex_ = false;
  bool is_one_shell_ = false;
  std::optional<MassProperties> mass_;
  MeshSource source_;
};

}  // namespace armlet
