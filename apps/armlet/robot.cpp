// armlet robot: the catalogue, the table of one robot, and robots as files.

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>

#include "armlet/core/files.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/interpreter/format.hpp"
#include "armlet/mesh/glb.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/model/robot_scene.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/stdlib/robot_text.hpp"
#include "console/console.hpp"
#include "console/output_file.hpp"
#include "console/setup.hpp"
#include "robot_table.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

void list_entry(bool json, std::string_view name, const std::string& kinds,
                const std::string& source) {
  if (json) {
    print_out(Json({{"name", name}, {"joints", kinds}, {"source", source}}).dump() + "\n");
  } else {
    print_out(fmt::format("{:<17} {:<8} {}\n", name, kinds, source));
  }
}

int list_robots(bool json) {
  for (const std::string_view name : catalog_names()) {
    const auto robot = make_robot(name);
    list_entry(json, name, kinds_of(*robot), robot->source());
  }
  for (const std::string_view name : hand_names()) {
    list_entry(json, name, "hand", make_hand(name)->source);
  }
  return finish_output() ? kDone : kFailed;
}

// The robot or hand that a name or file on the command line means.
struct Found {
  std::shared_ptr<const Robot> arm;
  std::optional<Hand> hand;
  std::optional<Mechanism> file;
  int exit = kDone;  // after a message, if it is neither
};

int refuse(const std::string& message, int exit) {
  progress("armlet: " + message);
  return exit;
}

// A mesh of a description as GLB; null if its format cannot be read.
Result<std::shared_ptr<const std::string>> read_mesh(const std::string& folder,
                                                     const std::string& mesh,
                                                     const PackageFolders& packages) {
  std::shared_ptr<const std::string> made;
  if (mesh_format(mesh).empty()) return made;
  const std::string path = find_mesh(folder, {}, mesh, packages);
  const std::size_t slash = path.rfind('/');
  Result<std::string> bytes = is_glb_name(path) ? armlet::read_file(path, kMostGlbBytes)
                                                : mesh_converter()(path.substr(0, slash + 1),
                                                                   path.substr(slash + 1), 0.0, {});
  if (!bytes.ok() && bytes.error().code == "converter") {
    progress(fmt::format("{} is left out: {}", mesh, bytes.error().message));
    return made;
  }
  if (!bytes.ok()) return bytes.error();
  made = std::make_shared<const std::string>(std::move(bytes).value());
  return made;
}

Found read_description(const RobotOptions& options) {
  Found found;
  const auto text = read_file(options.name, false);
  if (!text) {
    found.exit = kNoFile;
    return found;
  }
  const std::size_t slash = options.name.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "." : options.name.substr(0, slash);
  UrdfOptions urdf;
  if (options.published) urdf.inertia_check = InertiaCheck::kPublished;
  const PackageFolders packages = package_folders(options.packages);
  urdf.has_mesh = [&](const std::string& mesh) {
    return !find_mesh(folder, {}, mesh, packages).empty();
  };
  urdf.load_glb = [&](const std::string& mesh) { return read_mesh(folder, mesh, packages); };
  Result<Mechanism> read = read_urdf(*text, urdf);
  if (!read.ok()) {
    found.exit = refuse(fmt::format("{}: {}", options.name, read.error().message), kRejected);
    return found;
  }
  found.file.emplace(std::move(read).value());
  Result<RobotSpec> spec = serial_arm(*found.file, options.tip);
  if (spec.ok()) {
    for (const std::string& note : spec->notes)
      progress(fmt::format("armlet: {}: {}", options.name, note));
    found.arm = std::make_shared<const Robot>(std::move(spec).value());
  } else if (!options.urdf) {
    found.exit = refuse(fmt::format("{}: {}", options.name, spec.error().message), kRejected);
  }
  return found;
}

// The extension: from the last full stop on, in lower case.
std::string ending_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  std::string ending = dot == std::string::npos ? std::string() : name.substr(dot);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

Found find(const RobotOptions& options) {
  Found found;
  const std::string ending = ending_of(options.name);
  if (ending == ".urdf") return read_description(options);
  if (ending == ".xacro") {
    found.exit =
        refuse(fmt::format("{} is a xacro file, from which a description is made first: xacro {} > "
                           "arm.urdf",
                           options.name, options.name),
               kRejected);
    return found;
  }
  found.hand = make_hand(options.name);
  if (!found.hand) found.arm = find_robot(options.name);
  if (!found.hand && found.arm == nullptr) found.exit = kUsage;
  return found;
}

int print_urdf(const Found& found) {
  if (found.file) {
    print_out(write_urdf(*found.file));
  } else if (found.arm != nullptr) {
    print_out(write_urdf(Mechanism(mechanism_of(*found.arm))));
  } else if (found.hand->mechanism) {
    print_out(write_urdf(*found.hand->mechanism));
  } else {
    return refuse(fmt::format("{} has no joints to describe", found.hand->name), kUsage);
  }
  return finish_output() ? kDone : kFailed;
}

int print_block(const Found& found) {
  if (found.arm == nullptr) {
    return refuse(fmt::format("{} is a hand; a robot block describes an arm", found.hand->name),
                  kUsage);
  }
  if (found.arm->coupling() != nullptr) {
    return refuse(fmt::format("a robot block has no row for a joint that copies another one, as "
                              "{} has; read the description itself: robot arm = urdf(\"...\")",
                              found.arm->name()),
                  kUsage);
  }
  const Formatted laid_out = format_program(Source("robot.rbt", robot_block(*found.arm)));
  print_out(laid_out.text ? *laid_out.text : robot_block(*found.arm));
  return finish_output() ? kDone : kFailed;
}

int print_glb(const Found& found, const RobotOptions& options) {
  if (found.arm == nullptr) {
    return refuse(
        found.hand ? fmt::format("{} is a hand; shapes are made for arms", found.hand->name)
                   : fmt::format("{} is no single chain; shapes are made for arms", options.name),
        kUsage);
  }
  const std::string bytes = write_glb(robot_scene(*found.arm));
  if (options.glb_file.empty()) {
    if (isatty(STDOUT_FILENO) != 0) {
      return refuse(
          fmt::format("a GLB is not text; write it to a file: --glb {}.glb", found.arm->name()),
          kUsage);
    }
    print_out(bytes);
    return finish_output() ? kDone : kFailed;
  }
  OutputFile file("scene");
  file.set_path(options.glb_file);
  std::vector<std::string> read;
  if (found.file) read.push_back(options.name);
  if (const int exit = file.open(read); exit != kDone) return exit;
  file.file().write(bytes);
  return file.finish();
}

}  // namespace

int robot(const RobotOptions& options) {
  if (options.name.empty() && options.glb) {
    return refuse("the robot goes before the file: armlet robot puma560 --glb puma560.glb", kUsage);
  }
  if (options.name.empty() && (options.urdf || options.block)) {
    return refuse("of which robot? For example: armlet robot puma560 --urdf", kUsage);
  }
  if (options.name.empty()) return list_robots(options.json);
  const Found found = find(options);
  if (found.exit != kDone) return found.exit;
  if (options.urdf) return print_urdf(found);
  if (options.block) return print_block(found);
  if (options.glb) return print_glb(found, options);
  if (found.hand) {
    print_out(hand_text(*found.hand));
  } else {
    print_out(options.json ? robot_json(*found.arm) : robot_text(*found.arm));
  }
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
