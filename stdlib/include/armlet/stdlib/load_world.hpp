// Worlds in files.
#pragma once

#include <string>

#include "armlet/core/error.hpp"
#include "armlet/stdlib/mesh_converter.hpp"
#include "armlet/stdlib/session_log.hpp"

namespace armlet {

// The world that a file describes: a program that declares objects and frames (.rbt); the nodes of
// a GLB scene that have triangles, by their names; or the links of a URDF without joints of a
// robot. Scenes become such a program, whose names are theirs with _ for what no name of a program
// has. A link or node without a mass of its own is fixed if it is, or is fixed to, the root of a
// URDF.
//
// convert  makes GLB of the meshes that a URDF names; null: they must be GLB.
// returns  an error whose message says what is wrong: reading the file, and what is in it.
[[nodiscard]] Result<WorldText> load_world(const std::string& path,
                                           const MeshConverter& convert = {});

}  // namespace armlet
