#pragma once
// The program armlet-lab: its options, and the functions that serve or save a laboratory.

#include <string>

#include "commands.hpp"

namespace armlet::cli {

// Options of `armlet lab` when it serves pages to browsers.
struct LabOptions {
  bool demo = false;
  std::string host = "127.0.0.1";
  int port = 0;                        // 0: any free port
  std::string token_file;              // empty: from the environment variable, or a new token
  bool token_on_command_line = false;  // refused
  bool no_open = false;
  std::string export_to;  // a file that contains everything; empty: the page is served
  std::string engine;     // the engine for that file; empty: search the usual folders
};

// Serves pages to browsers until Ctrl-C.
int serve_lab(const LabOptions& options, const RunOptions& run);
// --export and --record FILE.html: saves a page that needs no command.
int save_lab(const LabOptions& options, const RunOptions& run);

}  // namespace armlet::cli
