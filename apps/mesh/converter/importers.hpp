#pragma once
// One function per format or library; each hides the library that reads it.

#include <string>
#include <string_view>

#include "converter/files.hpp"
#include "converter/scene_builder.hpp"

namespace armlet::mesh {

// The file to read.
//
// up  'y' or 'z': the axis of the file that points up; 0: as the format says.
struct Input {
  std::string format;  // as mesh_format gives it
  std::string name;    // of the file, without a folder
  std::string bytes;
  double unit = 0.0;  // m; 0: as the format says
  char up = 0;
};

// Loads what the libraries load at their first use, while the process can still open files.
void prepare_vrml();

// OBJ with MTL, 3DS, STL, DAE and PLY, by Assimp.
//
// throws  ArgumentError or another exception that says what is wrong.
void import_with_assimp(const Input& input, Files& files, SceneBuilder& scene);
// VRML 2.0, by Coin.
void import_vrml(const Input& input, Files& files, SceneBuilder& scene);
// The text with each ImageTexture renamed to MovieTexture, which has the same fields: Coin opens
// the file of an ImageTexture while it reads, but never that of a MovieTexture.
//
// throws  ArgumentError for contents with which Coin would open a file, run a script, or recurse
//         too deeply; films are among them.
std::string safe_vrml(std::string_view text);
// glTF and GLB as one GLB.
//
// throws  ArgumentError.
std::string pack_gltf(const Input& input, Files& files);

}  // namespace armlet::mesh
