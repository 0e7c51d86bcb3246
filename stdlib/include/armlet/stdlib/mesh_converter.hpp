// The function that converts meshes to GLB.
#pragma once

#include <functional>
#include <string>

#include "armlet/core/error.hpp"

namespace armlet {

// Makes a GLB of a mesh in another format: of the file `name` in a folder (it may read only this
// folder). `unit` is the length of one unit of the file, m; 0: as its format says. It stops when
// is_cancelled, called from time to time, returns true; null: never. An error with the code
// "converter" means that this host cannot convert meshes.
using MeshConverter =
    std::function<Result<std::string>(const std::string& folder, const std::string& name,
                                      double unit, const std::function<bool()>& is_cancelled)>;

}  // namespace armlet
