#include "armlet/core/error.hpp"
#include "armlet/mesh/glb.hpp"
#include "armlet/model/link.hpp"

namespace armlet {

std::shared_ptr<const TriangleMesh> triangles_of(const LinkMesh& mesh) {
  if (mesh.triangles) return mesh.triangles;
  if (!mesh.picture.bytes)
    throw ArgumentError("The mesh of a link has neither triangles nor a file.");
  TriangleMesh read = read_glb(*mesh.picture.bytes).value();
  read.set_source(mesh.picture.bytes);
  const Eigen::Vector3d factors = mesh.picture.T_mesh_file.linear().diagonal();
  if (factors != Eigen::Vector3d::Ones()) read = read.scaled(factors);
  return std::make_shared<const TriangleMesh>(std::move(read));
}

}  // namespace armlet
