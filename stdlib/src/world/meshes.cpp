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
  loaded = std::make_shared<const TriangleMesh>(std::move(triangles).value());
  return loaded;
}

// Of the whole file, or of one node.
static Result<TriangleMesh> triangles_in(const std::string& bytes,
                                         std::optional<std::string_view> part) {
  if (!part) return read_glb(bytes);
  Result<std::vector<GlbThing>> things = read_glb_things(bytes, std::string(*part));
  if (!things.ok()) return things.error();
  return std::move(things->front().triangles);
}

Answer<ShapeValue> mesh_shape(Vm& vm, std::string_view path, std::optional<double> density,
                              std::optional<std::string_view> part, double scale) try {
  constexpr std::size_t kMostBytes = 128 << 20;
  const std::string file(path);
  if (density && !(std::isfinite(*density) && *density > 0.0)) {
    return fail_mesh(vm, file,
                     fmt::format("its density is {} kg/m^3; expected more than 0", *density));
  }
  if (!(std::isfinite(scale) && scale > 0.0))
    return fail_mesh(vm, file, fmt::format("its scale is {}; expected more than 0", scale), {}, 3);
  const Result<std::string> bytes = Host::of(vm).load_file(file, kMostBytes);
  if (!bytes.ok()) return fail_mesh(vm, file, bytes.error().message);
  Result<TriangleMesh> triangles = triangles_in(*bytes, part);
  if (!triangles.ok()) return fail_mesh(vm, file, triangles.error().message, {}, part ? 2 : 0);
  if (scale != 1.0) triangles = triangles->scaled(Eigen::Vector3d::Constant(scale));
  if (!triangles->is_closed()) {
    return fail_mesh(vm, file, triangles->open_because(),
                     "close it where it was made: an object needs an inside to have a volume");
  }
  return ShapeValue{make_mesh(*triangles, density.value_or(0.0), file)};
} catch (const ArgumentError& error) {
  return fail_mesh(vm, std::string(path), error.what());
}

}  // namespace armlet::bind
