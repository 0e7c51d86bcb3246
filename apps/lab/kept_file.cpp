#include "kept_file.hpp"

#include <fmt/format.h>

#include "armlet/mesh/glb.hpp"

namespace armlet::lab {
namespace {

constexpr int kMostNames = 100;

}  // namespace

Result<KeptFile> keep_beside(
    const std::string& name, const std::string& bytes,
    const std::function<NameInUse(const std::string&)>& look,
    const std::function<std::optional<Error>(const std::string&, const std::string&)>& save) {
  if (!is_glb_name(name)) {
    return Error{"kind", fmt::format("{} is none of {}.", name, kMeshFormats)};
  }
  const Result<TriangleMesh> mesh = read_glb(bytes);
  if (!mesh.ok())
    return Error{"mesh", fmt::format("{} cannot be used: {}.", name, mesh.error().message)};
  const Eigen::Vector3d size = mesh->high() - mesh->low();
  const std::size_t point = name.rfind('.');
  for (int k = 1; k <= kMostNames; ++k) {
    const std::string tried =
        k == 1 ? name : fmt::format("{}-{}{}", name.substr(0, point), k, name.substr(point));
    const NameInUse known = look(tried);
    if (known.is_used && known.bytes == bytes)
      return KeptFile{tried, {size.x(), size.y(), size.z()}};
    if (known.is_used) continue;
    if (const std::optional<Error> why = save(tried, bytes))
      return Error{"save", fmt::format("{} cannot be kept: {}.", tried, why->message)};
    return KeptFile{tried, {size.x(), size.y(), size.z()}};
  }
  return Error{"name",
               fmt::format("There are {} files with names like {} already.", kMostNames, name)};
}

}  // namespace armlet::lab
