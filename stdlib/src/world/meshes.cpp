#include "world/meshes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/mesh/glb.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"

namespace armlet::bind {

Failed fail_mesh(Vm& vm, std::string_view path, std::string_view why, std::string fix,
                 int parameter) {
  Failure f;
  f.headline = {row("R0656"), {std::string(path), std::string(why)}};
  f.mark_parameter = parameter;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Result<std::shared_ptr<const TriangleMesh>> load_link_mesh(Vm& vm, const std::string& file,
                                                           const std::string& mesh) {
  std::shared_ptr<const TriangleMesh> loaded;
  if (!is_glb_name(mesh)) return loaded;
  const Result<std::string> bytes = Host::of(vm).load_mesh(file, mesh);
  if (!bytes.ok()) return bytes.error();
  Result<TriangleMesh> triangles = read_glb(*bytes);
  if (!triangles.ok()) return triangles.error();
  TriangleMesh known = std::move(triangles).value();
  known.set_source(std::make_shared<const std::string>(*bytes));
  loaded = std::make_shared<const TriangleMesh>(std::move(known));
  return loaded;
}

Answer<ShapeValue> mesh_shape(Vm& vm, std::string_view path, std::optional<double> density) try {
  constexpr std::size_t kMostBytes = 128 << 20;
  const std::string file(path);
  if (density && !(std::isfinite(*density) && *density > 0.0)) {
    return fail_mesh(vm, file,
                     fmt::format("its density is {} kg/m^3; expected more than 0", *density));
  }
  const Result<std::string> bytes = Host::of(vm).load_file(file, kMostBytes);
  if (!bytes.ok()) return fail_mesh(vm, file, bytes.error().message);
  Result<TriangleMesh> read = read_glb(*bytes);
  if (!read.ok()) return fail_mesh(vm, file, read.error().message);
  TriangleMesh triangles = std::move(read).value();
  triangles.set_source(std::make_shared<const std::string>(*bytes));
  if (!triangles.is_closed()) {
    return fail_mesh(vm, file, triangles.open_because(),
                     "close it where it was made: an object needs an inside to have a volume");
  }
  return ShapeValue{make_mesh(triangles, density.value_or(0.0), file)};
} catch (const ArgumentError& error) {
  return fail_mesh(vm, std::string(path), error.what());
}

}  // namespace armlet::bind
