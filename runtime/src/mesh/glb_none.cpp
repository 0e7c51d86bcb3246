// In place of glb_read.cpp where files cannot be had.

#include "armlet/mesh/glb.hpp"

namespace armlet {

Result<TriangleMesh> read_glb(std::string_view) {
  return Error{"mesh", "this build of Armlet does not read meshes; the armlet command does"};
}

}  // namespace armlet
