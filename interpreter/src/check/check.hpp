#pragma once
// Checks a program: names, types, units, rules of the host. The result is the typed tree that the
// compiler reads.

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/engine.hpp"
#include "compile/program.hpp"
#include "registry.hpp"
#include "syntax/ast.hpp"

namespace armlet::lang {

// Fills into.module, types, arena, facts and mentioned. Messages go to `sink`; the tree may be
// compiled only if there were no errors.
//
// program  the syntax tree; it and its arena may be dropped afterwards.
// into     into.sources must hold the program's texts and stay where they are: the tree points into
// them. returns  whether there were no errors.
bool check_program(const ast::Block& program, CompiledProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink);

}  // namespace armlet::lang
