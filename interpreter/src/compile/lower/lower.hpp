#pragma once
// Turns a checked program into bytecode.

#include <atomic>
#include <optional>

#include "armlet/interpreter/diagnostic.hpp"
#include "compile/code/program.hpp"

namespace armlet::lang {

struct LowerOptions {
  const std::atomic<bool>* cancelled = nullptr;  // by the host: lowering throws Cancelled soon
  bool optimise = true;                          // off: plain code with the same results
  bool markers = false;  // an instruction before each statement, and where its variables are
};

// Fills the functions and tables of `program` from program.module.
// returns  a message if the program is too large for the machine; nothing if all is well.
[[nodiscard]] std::optional<Diagnostic> lower(CompiledProgram& program, LowerOptions options = {});

}  // namespace armlet::lang
