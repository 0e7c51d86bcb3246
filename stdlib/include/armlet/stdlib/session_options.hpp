#pragma once
// What a session is made with.

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

// What sessions that take the same runs share.
//
// pictures  of cameras (Cameras::keep_pictures); null: each is drawn again.
struct SharedBySessions {
  std::shared_ptr<KeptPictures> pictures;
};

// Where meshes come from that programs name: see HostOptions.
struct MeshSources {
  MeshConverter convert{};
  PackageFolders packages{};
};

struct SessionOptions : SharedBySessions {
  std::shared_ptr<const Robot> robot;      // for programs that declare none; null: none
  std::vector<NamedPlanner> planners;      // beside the built-in ones
  std::optional<WorldText> world;          // given by the user
  std::optional<WorldText> default_world;  // when a program names an object and none is given
  std::filesystem::path folder;            // below which the program may write files; empty: none
  MeshSources meshes{};
  HostFrames frames{};      // pictures of cameras that the host gives
  bool keeps_files = true;  // otherwise what it saves can be loaded, and goes with the run
  ParseLimits parse_limits;
  bool open = false;     // see CompileOptions
  bool markers = false;  // see CompileOptions
  // After the end of the program the run waits for inputs (laboratory_controls.hpp).
  bool laboratory = false;
  std::function<void(const PressReport&)> on_press;
  ModuleLoader load;  // files that the program imports; none without it
  RunLimits limits;
  std::vector<Backend*> backends;               // must outlive the session
  std::function<bool(std::int64_t t_ns)> pace;  // see HostOptions
  Output output;
  std::function<void(const Diagnostic&)> advice;
  std::function<void(const MoveReport&)> on_move;
};

}  // namespace armlet
