#include "console/setup.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "armlet/core/files.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/workspace.hpp"
#include "client/convert.hpp"
#include "console/console.hpp"

namespace armlet::cli {

MeshConverter mesh_converter() {
  return [](const std::string& path, const std::string& name, double unit,
            const std::function<bool()>& is_cancelled) -> Result<std::string> {
    const Result<Folder> folder = Folder::open(path);
    if (!folder.ok()) return folder.error();
    mesh::ConvertOptions how;
    how.unit = unit;
    how.cache = mesh::mesh_cache_folder();
    how.is_cancelled = is_cancelled;
    how.progress = [&](const std::string& stage, int seconds) { show_stage(name, stage, seconds); };
    Result<std::string> glb = mesh::convert_mesh(*folder, path, name, how);
    if (shows_status()) status_line({});
    return glb;
  };
}

PackageFolders package_folders(const std::vector<std::string>& named) {
  PackageFolders packages;
  for (const std::string& each : named) {
    const std::size_t equals = each.find('=');
    packages.named[each.substr(0, equals)] = each.substr(equals + 1);
  }
  const char* path = std::getenv("ROS_PACKAGE_PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) packages.folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return packages;
}

std::shared_ptr<const Robot> find_robot(const std::string& name) {
  auto robot = robot_from_catalog(name);
  if (robot.ok()) return std::move(robot).value();
  progress("armlet: " + robot.error().message);
  return nullptr;
}

Setup make_setup(const ProgramOptions& options, const std::string& file) {
  Setup setup;
  Result<SessionOptions> made =
      session_options({file, options.robot, options.world, mesh_converter()});
  if (!made.ok() && made.error().code == "robot") {
    progress("armlet: " + made.error().message);
    setup.exit = kUsage;
    return setup;
  }
  if (!made.ok()) {
    show_unreadable(options.world, made.error().message, options.json);
    setup.exit = kNoFile;
    return setup;
  }
  SessionOptions& session = setup.session = std::move(made).value();
  if (session.world) {
    const SourceSet none;
    for (const std::string& note : session.world->notes)
      show(make_diagnostic("W0743", kNoText, {options.world, note}), none, options.json);
  }
  session.meshes.packages = package_folders(options.packages);
  session.limits.steps = options.steps;
  session.output = [](std::string_view text) {
    print_out(text);
    return output_fault();
  };
  return setup;
}

}  // namespace armlet::cli
