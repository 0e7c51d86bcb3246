#pragma once
// Checks a program: names, types, units, rules of the host. The result is the typed tree that the
// compiler reads.

#include <span>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "check/state/file_tree.hpp"
#include "hir/checked_program.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

class Learnt;

// Fills into.module, types, arena, facts and names. Messages go to `sink`; the tree may be
// compiled only if there were no errors.
//
// files  imported ones before those that import them, the main file last; they and their arena may
//        be dropped afterwards.
// into   into.sources must hold the program's texts and stay where they are: the tree points into
//        them.
// learnt  what the check finds out besides, also where it fails; null: not asked for.
// returns  whether there were no errors.
bool check_program(std::span<const FileTree> files, CheckedProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink, Learnt* learnt = nullptr);

}  // namespace armlet::lang
