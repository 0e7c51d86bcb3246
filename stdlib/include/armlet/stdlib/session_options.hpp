#pragma once
// The options of a session.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "armlet/backend/backend.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/session_log.hpp"

namespace armlet {

// Data shared by sessions that replay the same runs.
//
// pictures  of cameras (Cameras::keep_pictures); null: each picture is rendered again.
struct SharedBySessions {
  std::shared_ptr<KeptPictures> pictures;
};

// How meshes that programs name are found and converted: see HostOptions.
struct MeshSources {
  MeshConverter convert{};
  PackageFolders packages{};
};

struct SessionOptions : SharedBySessions {
  std::shared_ptr<const Robot> robot;      // for programs that declare none; null: no robot
  std::vector<NamedPlanner> planners;      // in addition to the built-in ones
  std::optional<WorldText> world;          // given by the user
  std::optional<WorldText> default_world;  // when a program names an object and none is given
  std::filesystem::path folder;            // programs write files only below it; empty: never
  MeshSources meshes{};
  HostFrames frames{};      // camera pictures that the host supplies
  bool keeps_files = true;  // false: saved files exist only in the run; it can load them
  ParseLimits parse_limits;
  bool open = false;     // see CompileOptions
  bool markers = false;  // see CompileOptions
  // After the end of the program the run waits for inputs (laboratory_controls.hpp).
  bool laboratory = false;
  std::function<void(const PressReport&)> on_press;
  ModuleLoader load;  // loads files that the program imports; null: imports fail
  RunLimits limits;
  std::vector<Backend*> backends;               // must outlive the session
  std::function<bool(std::int64_t t_ns)> pace;  // see HostOptions
  Output output;
  std::function<void(const Diagnostic&)> advice;
  std::function<void(const FinishedMove&)> on_move;
};

}  // namespace armlet
