// Worlds in files.
#pragma once

#include <string>

#include "armlet/core/error.hpp"
#include "armlet/stdlib/mesh_converter.hpp"
#include "armlet/stdlib/session_log.hpp"

namespace armlet {

// The world that a file describes: a program that declares objects and frames (.rbt); the nodes of
// a GLB scene that have triangles, by their names; or the links of a URDF without joints of a
// robot. A scene becomes such a program; in names, _ replaces each character that names of programs
// cannot have. A link or node without a mass of its own is fixed if it is the root of a URDF or is
// fixed to it.
//
// convert  makes GLB of the meshes that a URDF names; null: they must be GLB.
// returns  an error whose message says what is wrong with the file or its contents.
[[nodiscard]] Result<WorldText> load_world(const std::string& path,
                                           const MeshConverter& convert = {});

}  // namespace armlet
