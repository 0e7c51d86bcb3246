#pragma once
// The options on command lines that several commands have.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.hpp"

namespace armlet::cli {

// The option for packages whose meshes a description names.
void add_packages(CLI::App& command, std::vector<std::string>& packages);

// The options of every command that reads a program.
void add_program_options(CLI::App& command, ProgramOptions& options);

// The options for outputs of a run, of every command that runs a program to its end. With `needed`,
// the command runs one only when that option is given, and all of them but --record need it.
void add_run_outputs(CLI::App& command, RunOptions& run, CLI::Option* needed);

}  // namespace armlet::cli
