#pragma once
// Loads the files of a program: the main file and all that it imports.

#include <vector>

#include "armlet/interpreter/host/compile_options.hpp"
#include "base/arena.hpp"
#include "check/check.hpp"
#include "syntax/parse.hpp"

namespace armlet::lang {

// Loads and parses the files that the main file, sources[sources.first()], imports directly or
// through others. Each file is loaded once, even if several files import it. Files that cannot be
// loaded, and files that import each other, are reported to `sink`. A file that an earlier entry
// imported is not parsed again if the file and its imports are unchanged.
//
// main_file  if set: gets the result of parse_and_mend for the main file, with `before`.
// returns    the trees in `tree`, imported files before those that import them, the main file last.
[[nodiscard]] std::vector<FileTree> load_files(SourceSet& sources, Arena& tree,
                                               const CompileOptions& options, DiagnosticSink& sink,
                                               Mended* main_file = nullptr,
                                               const ReadBefore* before = nullptr);

}  // namespace armlet::lang
