// armlet mesh: converts a mesh of another format to GLB.

#include "client/convert.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "armlet/core/files.hpp"
#include "armlet/mesh/glb.hpp"
#include "commands.hpp"
#include "console/console.hpp"
#include "console/output_file.hpp"
#include "console/setup.hpp"

namespace armlet::cli {
namespace {

int refuse_mesh(const std::string& message, int exit) {
  progress("armlet: " + message);
  return exit;
}

// The length "1mm", "2.54 cm" or "0.001" (metres) in m; nullopt unless it is a length above zero.
std::optional<double> length_of(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  std::string unit(read.ptr, end);
  while (unit.starts_with(' ')) unit.erase(0, 1);
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1.0}, {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}, {"in", 0.0254}};
  for (const auto& [name, metres] : kUnits) {
    if (read.ec == std::errc() && unit == name && std::isfinite(value) && value > 0.0)
      return value * metres;
  }
  return std::nullopt;
}

}  // namespace

int convert_mesh(const MeshOptions& options) {
  mesh::ConvertOptions how;
  if (!options.unit.empty()) {
    const auto unit = length_of(options.unit);
    if (!unit) {
      return refuse_mesh(
          fmt::format("--unit takes a length above 0, such as 1mm, not \"{}\"", options.unit),
          kUsage);
    }
    how.unit = *unit;
  }
  if (!options.up.empty()) how.up = options.up.front();
  if (!is_glb_name(options.to))
    return refuse_mesh(fmt::format("what is written is a GLB: {} has to end in .glb", options.to),
                       kUsage);
  if (mesh_format(options.from).empty()) {
    return refuse_mesh(
        fmt::format("{} ends in no format that is read: {}", options.from, kMeshFormats), kUsage);
  }
  if (!options.quiet)
    how.progress = [&](const std::string& stage, int seconds) {
      show_stage(options.from, stage, seconds);
    };
  const Result<std::string> glb = mesh::convert_mesh(options.from, how);
  if (how.progress && shows_status()) status_line({});
  if (!glb.ok()) {
    const std::string& code = glb.error().code;
    const int exit = code == "missing" ? kNoFile : code == "converter" ? kFailed : kRejected;
    return refuse_mesh(fmt::format("{}: {}", options.from, glb.error().message), exit);
  }
  OutputFile file("mesh");
  file.set_path(options.to);
  if (const int exit = file.open({options.from}); exit != kDone) return exit;
  file.file().write(*glb);
  if (const int exit = file.finish(); exit != kDone) return exit;
  for (const std::string& note : glb_notes(*glb))
    progress(fmt::format("{}: {}", options.from, note));
  if (!options.quiet) {
    const Result<TriangleMesh> read = read_glb(*glb);
    if (read.ok()) {
      const Eigen::Vector3d size = (1e9 * (read->high() - read->low())).array().round() / 1e9;
      progress(fmt::format("{}: {} triangles, {:.4g} x {:.4g} x {:.4g} m, {}", options.to,
                           read->triangles().size(), size.x(), size.y(), size.z(),
                           read->is_closed() ? "closed" : read->open_because()));
    }
  }
  return kDone;
}

}  // namespace armlet::cli
