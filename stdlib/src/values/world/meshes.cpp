#include "values/world/meshes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/mesh/glb.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"

namespace armlet::bind {

Failed fail_mesh(Vm& vm, std::string_view path, std::string_view why, std::string fix,
                 CallPart part) {
  Failure f;
  f.headline = {row("R0656"), {std::string(path), std::string(why)}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

namespace {

// W0742: a mesh that is probably not what its author intended.
void advise_doubt(Vm& vm, const std::string& path, const std::string& why, std::string fix) {
  Failure advice;
  advice.headline = {row("W0742"), {path, why}};
  advice.mark = CallPart::callee();
  advice.fix = std::move(fix);
  vm.advise(advice);
}

// W0740: parts of its source that a converted mesh lacks; other notes of the converter are W0742.
void advise_notes(Vm& vm, const std::string& path, const std::string& bytes) {
  for (const std::string& note : glb_notes(bytes)) {
    if (!note.ends_with("left out") && note.find(" is left out: ") == std::string::npos &&
        !note.starts_with("the file ")) {
      advise_doubt(vm, path, note, "write the file again with the program that made it");
      continue;
    }
    Failure advice;
    advice.headline = {row("W0740"), {path, note}};
    advice.mark = CallPart::callee();
    advice.fix = "put it beside the mesh, or take its name out of the file";
    vm.advise(advice);
  }
}

Failed fail_unread(Vm& vm, const std::string& path, const Error& error) {
  if (error.code != "converter") return fail_mesh(vm, path, error.message);
  Failure f;
  f.headline = {row("R0660"), {path}};
  f.mark = CallPart::first();
  f.why = error.message;
  return fail(vm, std::move(f));
}

}  // namespace

Result<std::shared_ptr<const std::string>> load_link_glb(Vm& vm, const std::string& file,
                                                         const std::string& mesh, double unit) {
  std::shared_ptr<const std::string> loaded;
  if (mesh_format(mesh).empty()) return loaded;
  Result<std::string> bytes = Host::of(vm).load_mesh(file, mesh, unit);
  if (!bytes.ok() && bytes.error().code == "converter") {
    Failure advice;
    advice.headline = {row("W0741"), {mesh}};
    advice.mark = CallPart::callee();
    advice.why = bytes.error().message;
    vm.advise(advice);
    return loaded;
  }
  if (!bytes.ok()) return bytes.error();
  advise_notes(vm, mesh, *bytes);
  loaded = std::make_shared<const std::string>(std::move(bytes).value());
  return loaded;
}

Result<std::shared_ptr<const TriangleMesh>> load_link_mesh(Vm& vm, const std::string& file,
                                                           const std::string& mesh,
                                                           const LinkMeshSize& size) try {
  std::shared_ptr<const TriangleMesh> loaded;
  const auto bytes = load_link_glb(vm, file, mesh, size.unit);
  if (!bytes.ok()) return bytes.error();
  if (*bytes == nullptr) return loaded;
  Result<TriangleMesh> triangles = read_glb(**bytes);
  if (!triangles.ok()) return triangles.error();
  TriangleMesh known = std::move(triangles).value();
  known.set_source(*bytes);
  if (size.scale != 1.0) known = known.scaled(Eigen::Vector3d::Constant(size.scale));
  loaded = std::make_shared<const TriangleMesh>(std::move(known));
  return loaded;
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

// The mesh of a file or of one of its nodes, with the bytes that displays read.
static Result<TriangleMesh> triangles_in(const std::string& bytes,
                                         std::optional<std::string_view> part) {
  if (!part) {
    Result<TriangleMesh> read = read_glb(bytes);
    if (!read.ok()) return read.error();
    TriangleMesh whole = std::move(read).value();
    whole.set_source(std::make_shared<const std::string>(bytes));
    return whole;
  }
  Result<std::vector<GlbThing>> things = read_glb_things(bytes, std::string(*part));
  if (!things.ok()) return things.error();
  TriangleMesh triangles = things->front().triangles;
  Result<std::string> cut = cut_glb(bytes, things->front());
  if (!cut.ok()) return cut.error();
  triangles.set_source(std::make_shared<const std::string>(std::move(cut).value()));
  return triangles;
}

Answer<ShapeValue> mesh_shape(Vm& vm, std::string_view path, std::optional<double> density,
                              std::optional<double> unit, std::optional<std::string_view> part,
                              double scale) try {
  const std::string file(path);
  if (density && !(std::isfinite(*density) && *density > 0.0)) {
    return fail_mesh(vm, file,
                     fmt::format("its density is {} kg/m^3; expected more than 0", *density), {},
                     at("density"));
  }
  if (unit && !(std::isfinite(*unit) && *unit > 0.0)) {
    return fail_mesh(vm, file, fmt::format("its unit is {} m; expected more than 0", *unit), {},
                     at("unit"));
  }
  if (!(std::isfinite(scale) && scale > 0.0)) {
    return fail_mesh(vm, file, fmt::format("its scale is {}; expected more than 0", scale), {},
                     at("scale"));
  }
  const Result<std::string> bytes = Host::of(vm).load_shape(file, unit.value_or(0.0));
  if (!bytes.ok()) return fail_unread(vm, file, bytes.error());
  advise_notes(vm, file, *bytes);
  Result<TriangleMesh> triangles = triangles_in(*bytes, part);
  if (!triangles.ok())
    return fail_mesh(vm, file, triangles.error().message, {}, part ? at("part") : at("path"));
  if (scale != 1.0) triangles = triangles->scaled(Eigen::Vector3d::Constant(scale));
  if (!triangles->is_closed()) {
    return fail_mesh(vm, file, triangles->open_because(),
                     "close it where it was made: an object needs an inside to have a volume");
  }
  if (!triangles->doubled_because().empty()) {
    advise_doubt(vm, file, triangles->doubled_because(),
                 "unite its parts where it was made, or give the object its `mass:`");
  }
  return ShapeValue{make_mesh(*std::move(triangles), density.value_or(0.0), file)};
} catch (const ArgumentError& error) {
  return fail_mesh(vm, std::string(path), error.what());
}

}  // namespace armlet::bind
