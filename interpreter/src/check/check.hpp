#pragma once
// Checks a program: names, types, units, rules of the host. The result is the typed tree that the
// compiler reads.

#include <span>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "ast/ast.hpp"
#include "hir/checked_program.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

class Learnt;
struct KeptFile;

// One file of a program, as written.
struct FileTree {
  // An import and the number of the file that it names; -1: there is none, which was told.
  struct Import {
    const ast::ImportStmt* statement;
    int file;
    const KeptFile* kept = nullptr;  // the file as an earlier entry has read it
  };
  ast::Block program{};
  bool ok = true;  // false: statements with mistakes are missing
  std::vector<Import> imports{};
};

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
