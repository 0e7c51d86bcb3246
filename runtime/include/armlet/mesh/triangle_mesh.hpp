// Bodies whose surface is made of triangles.
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

// Of a body of density 1: volume, m^3, centre of mass, m, and inertia about it in the axes of the
// mesh, m^5. Multiplied by a density in kg/m^3 they are kg and kg m^2.
struct MassProperties {
  double volume = 0.0;
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

// Boxes around triangles and around those boxes. A node's first child follows it, the second is
// `second`; leaves have none (0) and hold the triangles order[begin] to order[end - 1].
struct TriangleTree {
  struct Node {
    Eigen::Vector3d low, high;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t second = 0;
  };
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;
};

// The GLB file that a mesh was read from, for whoever draws it: surfaces have looks there.
//
// bytes        shared by all meshes that came from them; null: it was made otherwise.
// T_mesh_file  from the coordinates of the file, z up, to those of the mesh.
struct MeshSource {
  std::shared_ptr<const std::string> bytes;
  Eigen::Affine3d T_mesh_file = Eigen::Affine3d::Identity();
};

// Triangles, counterclockwise seen from outside. Corners at the same position are one; triangles
// without three different corners are left out. The same bits on every machine.
class TriangleMesh {
 public:
  // vertices  m.
  // throws    ArgumentError that says what is wrong: no triangles, more than kMostTriangles, an
  //           index that no vertex has, a coordinate that is no number or beyond 10 km.
  TriangleMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Corners> triangles);

  [[nodiscard]] const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
  [[nodiscard]] const Eigen::Vector3d& corner(std::size_t triangle, std::size_t k) const {
    return vertices_[triangles_[triangle][k]];
  }

  // The box around it.
  [[nodiscard]] const Eigen::Vector3d& low() const { return tree_.nodes.front().low; }
  [[nodiscard]] const Eigen::Vector3d& high() const { return tree_.nodes.front().high; }
  // Radius of a ball about the origin that holds it, m.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }

  // Why it is no surface of a body, as a sentence without an end; empty if it is one: every edge
  // is as often gone in one direction as in the other. A surface with the inside outside is turned
  // when it is made, and so is a closed part of it that lies in no other one.
  [[nodiscard]] const std::string& open_because() const { return open_because_; }
  [[nodiscard]] bool is_closed() const { return open_because_.empty(); }
  // Why its volume counts some of it more than once, as a sentence without an end; empty if it does
  // not: closed parts of it overlap, or lie in one another without being cavities; or are too many
  // to find out.
  [[nodiscard]] const std::string& doubled_because() const { return doubled_because_; }
  // Closed, in one piece, without a hole through it, and bent outward at every edge.
  [[nodiscard]] bool is_convex() const { return is_convex_; }

  // Of a closed one; nothing if it is open. Parts that lie in one another count each.
  //
  // source  divergence theorem over signed tetrahedra: S. Lien, J. T. Kajiya, A symbolic method for
  //         calculating the integral properties of arbitrary nonconvex polyhedra, IEEE Computer
  //         Graphics and Applications 4, 1984.
  [[nodiscard]] const std::optional<MassProperties>& mass_properties() const { return mass_; }

  // The vertex that lies farthest along d.
  [[nodiscard]] const Eigen::Vector3d& farthest(const Eigen::Vector3d& d) const;
  // Whether a point lies inside of a closed surface; false for an open one. On the surface either.
  [[nodiscard]] bool holds(const Eigen::Vector3d& p) const;

  // Where it comes from; meshes made from it by `scaled` and `moved` know it too.
  [[nodiscard]] const MeshSource& source() const { return source_; }
  void set_source(std::shared_ptr<const std::string> glb) { source_ = {.bytes = std::move(glb)}; }

  // The same triangles, longer along each axis by a factor; a mirrored one is turned.
  //
  // throws  ArgumentError as when it is made.
  [[nodiscard]] TriangleMesh scaled(const Eigen::Vector3d& factors) const;
  // The same triangles, moved.
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
