#pragma once
// Meshes in the files of a program.

#include <memory>
#include <optional>
#include <string>

#include "armlet/interpreter/engine.hpp"
#include "armlet/mesh/triangle_mesh.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// R0656: the reason why the mesh of a file cannot be used. Marks `part`.
Failed fail_mesh(Vm& vm, std::string_view path, std::string_view why, std::string fix = {},
                 CallPart part = CallPart::first());

// mesh(path, density, unit, part, scale): a body.
Answer<ShapeValue> mesh_shape(Vm& vm, std::string_view path, std::optional<double> density,
                              std::optional<double> unit, std::optional<std::string_view> part,
                              double scale);

// The mesh of a link as the bytes of a GLB, from the file that `file` names (empty: the program
// itself names it). Null if its format cannot be read, or would have to be converted and there is
// no converter (W0741).
//
// unit  length of one unit of the file, m; 0: as it says.
Result<std::shared_ptr<const std::string>> load_link_glb(Vm& vm, const std::string& file,
                                                         const std::string& mesh,
                                                         double unit = 0.0);
// The mesh of a link with its triangles.
//
// unit, scale  length of one unit of the file, m, 0: as it says; and the scale factor, > 0.
struct LinkMeshSize {
  double unit = 0.0;
  double scale = 1.0;
};
Result<std::shared_ptr<const TriangleMesh>> load_link_mesh(Vm& vm, const std::string& file,
                                                           const std::string& mesh,
                                                           const LinkMeshSize& size = {});

}  // namespace armlet::bind
