// In place of glb_read.cpp where files cannot be had.

#include "armlet/mesh/glb.hpp"

namespace armlet {

Result<TriangleMesh> read_glb(std::string_view) {
  return Error{"mesh", "this build of Armlet does not read meshes; the armlet command does"};
}

Result<std::vector<GlbThing>> read_glb_things(std::string_view, const std::string&) {
  return read_glb({}).error();
}

}  // namespace armlet
