#pragma once
// Meshes of other formats as GLB, by the converter, which is a process of its own, and with a
// cache.

#include <functional>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/core/files.hpp"
#include "exchange.hpp"

namespace armlet::mesh {

// unit        m in one unit of the file; 0: as the format says, 1 m if it says nothing.
// up          'y' or 'z': the axis of the file that points up; 0: as the format says, z if it says
//             nothing.
// cache       the folder of what was made before; empty: nothing is kept.
// converter   the program; empty: where it is looked for.
// progress    null, or called about once a second: what is being done, and the seconds since the
//             start.
// is_cancelled  null, or asked many times a second: the conversion is given up when it says so.
struct ConvertOptions {
  double unit = 0.0;
  char up = 0;
  std::string cache{};
  std::string converter{};
  std::function<void(const std::string& stage, int seconds)> progress{};
  std::function<bool()> is_cancelled{};
  ConvertLimits limits{};
};

// The GLB of a mesh, whole, with its pictures inside: metres, z up when it is read. What it lacks
// of its source stands in its notes (glb_notes).
//
// folder, path  what may be read, and its path.
// name          of the mesh, relative to the folder.
// returns       an error whose message is a sentence without an end. Codes: converter (there is no
//               converter; the message says how to get it), those of Folder::read, mesh.
[[nodiscard]] Result<std::string> convert_mesh(const Folder& folder, const std::string& path,
                                               const std::string& name,
                                               const ConvertOptions& options = {});
// The same for a file that a person named; links on the way to it are followed.
[[nodiscard]] Result<std::string> convert_mesh(const std::string& file,
                                               const ConvertOptions& options = {});

// $XDG_CACHE_HOME/armlet/meshes, or ~/.cache/armlet/meshes; empty if neither is known.
[[nodiscard]] std::string mesh_cache_folder();
// The path of the converter: beside this program, or where packages put it; empty: it is not there.
[[nodiscard]] std::string find_converter();
// Why there is none, and what to do.
[[nodiscard]] std::string no_converter();

}  // namespace armlet::mesh
