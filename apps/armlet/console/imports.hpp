#pragma once
// Files that a program imports.

#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet::cli {

// Reads imported files, and tables whose columns the checker needs, relative to the file that
// imports them. A program can read files of its own folder and the folders below it, whatever the
// path says; links there are not followed.
[[nodiscard]] ModuleLoader imports_of(const std::string& program);

}  // namespace armlet::cli
