// What makes meshes readable.
#pragma once

#include <functional>
#include <string>

#include "armlet/core/error.hpp"

namespace armlet {

// Makes a GLB of a mesh in another format: the file `name` in a folder, which is what it may read,
// with `unit` m in one unit of it, 0 if its format says so. It gives up when is_cancelled, asked
// from time to time, says so; null: nobody cancels. An error with the code "converter" means that
// this host has no means to.
using MeshConverter =
    std::function<Result<std::string>(const std::string& folder, const std::string& name,
                                      double unit, const std::function<bool()>& is_cancelled)>;

}  // namespace armlet
