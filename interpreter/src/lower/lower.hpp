#pragma once
// Turns a checked program into bytecode.

#include <memory>
#include <optional>

#include "armlet/interpreter/diagnostic.hpp"
#include "lower/context/options.hpp"
#include "program/program.hpp"

namespace armlet::lang {

struct Lowered {
  std::unique_ptr<Program::Code> program;
  std::optional<Diagnostic> too_large;  // for the machine; nothing: all is well
};

// after  the entry that the checked one goes on from; null: there is none.
[[nodiscard]] Lowered lower(CheckedProgram checked, LowerOptions options = {},
                            std::shared_ptr<const Program> after = nullptr);

}  // namespace armlet::lang
