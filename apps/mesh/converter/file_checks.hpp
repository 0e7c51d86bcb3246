#pragma once
// What is looked at before a library reads a file: what it would take too much of, or fall over.

#include <string>
#include <string_view>
#include <vector>

#include "converter/importers.hpp"

namespace armlet::mesh {

// throws  ArgumentError.
void check_before_assimp(const Input& input);
// No entities, no loops of references, elements in one another that a recursion can follow.
//
// throws  ArgumentError.
void check_dae(std::string_view text);
// As many elements as the header says, each whole, with indices of vertices that are there.
//
// throws  ArgumentError.
void check_ply(std::string_view bytes);
// Text in lines, without bytes that no text has.
//
// throws  ArgumentError.
void check_lines(std::string_view text, std::string_view name);

// An STL file, text or binary, as a binary one of exactly its triangles. A binary file is one whose
// length is what its header says, whatever it begins with, and one that does not begin with
// `solid`.
//
// notes   gets what was passed over.
// throws  ArgumentError that says which word is missing, or both numbers of triangles.
std::string plain_stl(std::string_view bytes, std::vector<std::string>& notes);

}  // namespace armlet::mesh
