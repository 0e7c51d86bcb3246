#pragma once
// Conversion of meshes of other formats to GLB, by the converter, a separate process, with a
// cache.

#include <functional>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/core/files.hpp"
#include "exchange.hpp"

namespace armlet::mesh {

// unit        length of one unit of the file, m; 0: as the format says, 1 m if it says nothing.
// up          'y' or 'z': the axis of the file that points up; 0: as the format says, z if it
//             says nothing.
// cache       the folder of earlier results; empty: nothing is stored.
// converter   the path of the program; empty: searched for.
// progress    null, or called about once a second with the stage and the seconds since the
//             start.
// is_cancelled  null, or called many times a second: the conversion ends when it returns true.
struct ConvertOptions {
  double unit = 0.0;
  char up = 0;
  std::string cache{};
  std::string converter{};
  std::function<void(const std::string& stage, int seconds)> progress{};
  std::function<bool()> is_cancelled{};
  ConvertLimits limits{};
};

// The complete GLB of a mesh, including its pictures: metres, z up when it is read. Its notes
// (glb_notes) name parts of the source that it lacks.
//
// folder, path  the folder whose files may be read, and its path.
// name          of the mesh, relative to the folder.
// returns       an error whose message is a sentence without a full stop. Codes: converter (there
//               is no converter; the message says how to get it), those of Folder::read, mesh.
[[nodiscard]] Result<std::string> convert_mesh(const Folder& folder, const std::string& path,
                                               const std::string& name,
                                               const ConvertOptions& options = {});
// Converts a file that the user named; links in its path are followed.
[[nodiscard]] Result<std::string> convert_mesh(const std::string& file,
                                               const ConvertOptions& options = {});

// $XDG_CACHE_HOME/armlet/meshes, or ~/.cache/armlet/meshes; empty if neither is known.
[[nodiscard]] std::string mesh_cache_folder();
// The path of the converter: beside this program, or where packages install it; empty: not found.
[[nodiscard]] std::string find_converter();
// A message that the converter is missing, and how to get it.
[[nodiscard]] std::string no_converter();

}  // namespace armlet::mesh
