#pragma once
// Compiles a text to a program: parse, check, lower.

#include <string>

#include "armlet/interpreter/engine.hpp"
#include "lower/lower.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

// All mistakes in the text are returned as diagnostics.
[[nodiscard]] Compilation compile_text(const Registry& registry, std::string text, std::string name,
                                       const CompileOptions& options, LowerOptions lowering = {});

// The diagnostic for an exception that only a defect of Armlet, or a lack of memory, can cause.
[[nodiscard]] Diagnostic defect(const char* what);

}  // namespace armlet::lang
