#pragma once
// From text to program: parse, check, lower.

#include <string>

#include "armlet/interpreter/engine.hpp"
#include "lower/lower.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

// Everything that is wrong with the text comes back as diagnostics.
[[nodiscard]] Compilation compile_text(const Registry& registry, std::string text, std::string name,
                                       const CompileOptions& options, LowerOptions lowering = {});

// Reached only through a mistake of ours, or when the machine has no memory left.
[[nodiscard]] Diagnostic defect(const char* what);

}  // namespace armlet::lang
