#include "console/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "armlet/core/files.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/load_world.hpp"
#include "client/convert.hpp"
#include "console/console.hpp"
#include "console/imports.hpp"

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
  auto robot = make_robot(name);
  if (robot != nullptr) return robot;
  std::vector<std::string_view> names = catalog_names();
  names.insert(names.end(), hand_names().begin(), hand_names().end());
  std::string message = fmt::format("armlet: there is no robot called \"{}\"; there are {}", name,
                                    fmt::join(names, ", "));
  if (const auto meant = most_similar(name, names))
    message += fmt::format("\ndid you mean \"{}\"?", *meant);
  progress(message);
  return nullptr;
}

Setup make_setup(const ProgramOptions& options, const std::string& file) {
  Setup setup;
  SessionOptions& session = setup.session;
  session.load = imports_of(file);
  session.robot = find_robot(options.robot);
  if (session.robot == nullptr) {
    setup.exit = kUsage;
    return setup;
  }
  if (options.world.empty()) {
    session.default_world = table_world();
  } else {
    Result<WorldText> world = load_world(options.world, mesh_converter());
    if (!world.ok()) {
      show_unreadable(options.world, world.error().message, options.json);
      setup.exit = kNoFile;
      return setup;
    }
    const SourceSet none;
    for (const std::string& note : world->notes)
      show(make_diagnostic("W0743", kNoText, {options.world, note}), none, options.json);
    session.world = std::move(world).value();
  }
  // A program may write files only below its own folder.
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  session.folder = folder.empty() ? std::filesystem::path(".") : folder;
  session.meshes.convert = mesh_converter();
  session.meshes.packages = package_folders(options.packages);
  session.limits.steps = options.steps;
  session.output = [](std::string_view text) {
    print_out(text);
    return output_fault();
  };
  return setup;
}

}  // namespace armlet::cli
