#pragma once
// The checker: checks names, types, units and rules of the host. The result is the typed tree for
// the compiler.

#include <span>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "check/state/file_tree.hpp"
#include "hir/checked_program.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

class Learnt;

// Checks a program and fills into.module, types, arena, facts and names. Messages go to `sink`; the
// tree may be compiled only if there were no errors.
//
// files    imported ones before those that import them, the main file last; they and their arena
//          may be freed afterwards.
// into     into.sources must have the texts of the program and must not be moved: the tree refers
//          to them.
// learnt   gets further results for editors, also if the check fails; null: not needed.
// returns  whether there were no errors.
bool check_program(std::span<const FileTree> files, CheckedProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink, Learnt* learnt = nullptr);

}  // namespace armlet::lang
