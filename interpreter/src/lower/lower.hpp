#pragma once
// Compiles a checked program to bytecode.

#include <memory>
#include <optional>

#include "armlet/interpreter/diagnostic.hpp"
#include "lower/context/options.hpp"
#include "program/program.hpp"

namespace armlet::lang {

struct Lowered {
  std::unique_ptr<Program::Code> program;
  // The error if the program is too large for the virtual machine; empty if there is none.
  std::optional<Diagnostic> too_large;
};

// after  the entry of the session before the checked one; null for the first one and for programs.
[[nodiscard]] Lowered lower(CheckedProgram checked, LowerOptions options = {},
                            std::shared_ptr<const Program> after = nullptr);

}  // namespace armlet::lang
