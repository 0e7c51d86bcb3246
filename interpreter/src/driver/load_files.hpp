#pragma once
// The files of a program: the main one and all that it imports.

#include <vector>

#include "armlet/interpreter/host/compile_options.hpp"
#include "base/arena.hpp"
#include "check/check.hpp"
#include "syntax/parse.hpp"

namespace armlet::lang {

// Reads and parses what the main file, which is sources[sources.first()], imports directly or
// through others. Each file is read once, however often it is imported. A file that cannot be had
// and files that import each other are told of in `sink`. A file that an earlier entry imported is
// not read again if nothing has changed in it and in what it imports.
//
// main_file  given: filled with what parse_and_mend says of the main file, with `before`.
// returns  the trees in `tree`, imported files before those that import them, the main file last.
[[nodiscard]] std::vector<FileTree> load_files(SourceSet& sources, Arena& tree,
                                               const CompileOptions& options, DiagnosticSink& sink,
                                               Mended* main_file = nullptr,
                                               const ReadBefore* before = nullptr);

}  // namespace armlet::lang
