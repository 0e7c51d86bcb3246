#include "urdf_meshes.hpp"

#include "armlet/mesh/glb.hpp"

namespace armlet {
namespace {

std::array<double, 3> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// A mesh without triangles.
LinkMesh drawn_from(UrdfMeshes::Bytes bytes, const Eigen::Vector3d& factors) {
  LinkMesh mesh;
  mesh.picture.bytes = std::move(bytes);
  mesh.picture.T_mesh_file.linear() = factors.asDiagonal();
  return mesh;
}

Result<LinkMesh> with_triangles(const LinkMesh& drawn) try {
  return LinkMesh{.triangles = triangles_of(drawn)};
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

}  // namespace

const Result<UrdfMeshes::Bytes>& UrdfMeshes::bytes_of(const std::string& name) {
  const auto known = bytes_.find(name);
  if (known != bytes_.end()) return known->second;
  return bytes_.emplace(name, load_ ? load_(name) : Result<Bytes>(Bytes())).first->second;
}

Result<LinkMesh> UrdfMeshes::body(const std::string& name, const Eigen::Vector3d& factors) {
  const Key key(name, numbers_of(factors));
  const auto known = bodies_.find(key);
  if (known != bodies_.end()) return known->second;
  const Result<Bytes>& bytes = bytes_of(name);
  if (!bytes.ok()) return bytes.error();
  if (!*bytes) return LinkMesh();
  return bodies_.emplace(key, with_triangles(drawn_from(*bytes, factors))).first->second;
}

Result<LinkMesh> UrdfMeshes::picture(const std::string& name, const Eigen::Vector3d& factors) {
  const Key key(name, numbers_of(factors));
  if (const auto body = bodies_.find(key); body != bodies_.end()) return body->second;
  if (const auto known = pictures_.find(key); known != pictures_.end()) return known->second;
  const Result<Bytes>& bytes = bytes_of(name);
  if (!bytes.ok()) return bytes.error();
  if (!*bytes) return LinkMesh();
  const auto fault = glb_fault(**bytes, factors);
  return pictures_.emplace(key, fault ? Result<LinkMesh>(*fault) : drawn_from(*bytes, factors))
      .first->second;
}

}  // namespace armlet
