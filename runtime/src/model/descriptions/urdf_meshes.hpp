// The meshes of a description, each file read once.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/model/link.hpp"

namespace armlet {

class UrdfMeshes {
 public:
  using Bytes = std::shared_ptr<const std::string>;
  using Load = std::function<Result<Bytes>(const std::string&)>;

  // load  as UrdfOptions::load_glb; null: no meshes are read.
  explicit UrdfMeshes(Load load) : load_(std::move(load)) {}

  // A mesh with triangles, for collision checks. It has neither triangles nor a picture if the file
  // type is not supported.
  Result<LinkMesh> body(const std::string& name, const Eigen::Vector3d& factors);
  // A mesh that is only drawn: without triangles, unless there is a body of the same size. The same
  // files are refused, for the same reasons.
  Result<LinkMesh> picture(const std::string& name, const Eigen::Vector3d& factors);

 private:
  // A file with its scale; arrays, because map keys need an order.
  using Key = std::pair<std::string, std::array<double, 3>>;
  const Result<Bytes>& bytes_of(const std::string& name);

  Load load_;
  std::map<std::string, Result<Bytes>> bytes_;
  std::map<Key, Result<LinkMesh>> bodies_, pictures_;
};

}  // namespace armlet
