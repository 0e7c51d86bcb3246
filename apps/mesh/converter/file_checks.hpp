#pragma once
// Checks before a library reads a file, of contents that would need too much time or crash it.

#include <string>
#include <string_view>
#include <vector>

#include "converter/importers.hpp"

namespace armlet::mesh {

// throws  ArgumentError.
void check_before_assimp(const Input& input);
// No entities, no loops of references, and elements nested not too deeply for a recursion.
//
// throws  ArgumentError.
void check_dae(std::string_view text);
// As many elements as the header says, each complete, with indices of existing vertices.
//
// throws  ArgumentError.
void check_ply(std::string_view bytes);
// Text in lines, without control bytes.
//
// throws  ArgumentError.
void check_lines(std::string_view text, std::string_view name);

// An STL file, text or binary, as a binary one with exactly its triangles. A file is binary if
// its length is what its header says, whatever it begins with, or if it does not begin with
// `solid`.
//
// notes   gets the parts that were ignored.
// throws  ArgumentError that says which word is missing, or both numbers of triangles.
std::string plain_stl(std::string_view bytes, std::vector<std::string>& notes);

}  // namespace armlet::mesh
