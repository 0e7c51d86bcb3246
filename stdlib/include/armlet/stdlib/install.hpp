#pragma once
// Adds the vocabulary of robot programs to an engine.

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// Everything of the language reference, section 19, that exists so far. Programs compiled by this
// engine need a Host as CompileOptions::host and VmOptions::host (see session.hpp, which does
// both).
void install(Engine& engine);

}  // namespace armlet
