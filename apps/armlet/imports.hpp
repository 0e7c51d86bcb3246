#pragma once
// Files that a program imports.

#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet::cli {

// Reads imported files, and tables of which a program reads the columns when it is checked,
// relative to the file that imports them. A program gets files of its own folder and of the folders
// below it, wherever a path leads; links are not followed there.
[[nodiscard]] ModuleLoader imports_of(const std::string& program);

}  // namespace armlet::cli
