#include "armlet/stdlib/workspace.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "armlet/core/similar.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/stdlib/load_world.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet {

Result<std::shared_ptr<const Robot>> robot_from_catalog(const std::string& name) {
  if (auto robot = make_robot(name)) return std::shared_ptr<const Robot>(std::move(robot));
  std::vector<std::string_view> names = catalog_names();
  names.insert(names.end(), hand_names().begin(), hand_names().end());
  std::string message =
      fmt::format("there is no robot called \"{}\"; there are {}", name, fmt::join(names, ", "));
  if (const auto meant = most_similar(name, names))
    message += fmt::format("\ndid you mean \"{}\"?", *meant);
  return Error{"robot", std::move(message)};
}

Result<SessionOptions> session_options(const Workspace& workspace) {
  SessionOptions options;
  options.load = imports_of(workspace.program);
  auto robot = robot_from_catalog(workspace.robot);
  if (!robot.ok()) return robot.error();
  options.robot = std::move(robot).value();
  if (workspace.world.empty()) {
    options.default_world = table_world();
  } else {
    Result<WorldText> world = load_world(workspace.world, workspace.convert);
    if (!world.ok()) return world.error();
    options.world = std::move(world).value();
  }
  const std::filesystem::path folder = std::filesystem::path(workspace.program).parent_path();
  options.folder = folder.empty() ? std::filesystem::path(".") : folder;
  options.meshes.convert = workspace.convert;
  return options;
}

}  // namespace armlet
