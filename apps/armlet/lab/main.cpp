// The program that `armlet lab` starts: it shows a program and its runs in browsers, or saves them as a
// page.

#include <CLI/CLI.hpp>

#include "console/console.hpp"
#include "console/options.hpp"
#include "lab/lab.hpp"

namespace {

using namespace armlet::cli;

void add_lab_options(CLI::App& command, LabOptions& lab, RunOptions& run) {
  CLI::Option* file =
      command.add_option("FILE", run.file, "the program; a new one begins from a template");
  add_program_options(command, run.program);
  command.add_flag("--demo", lab.demo, "an example instead of a program of your own")
      ->excludes(file);
  command.add_option("--port", lab.port, "of the address (default: any that is free)")
      ->type_name("P")
      ->check(CLI::Range(0, 65535));
  command
      .add_option("--host", lab.host,
                  "the address of this machine to be reached at (default: 127.0.0.1, from this "
                  "machine alone; 0.0.0.0: from everywhere, and not encrypted)")
      ->type_name("ADDRESS");
  command
      .add_option("--token-file", lab.token_file,
                  "a file with the secret in the page's address, at least 22 letters, digits, - "
                  "or _; also in the variable ARMLET_LAB_TOKEN (default: a new one each time)")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--token", [&lab](const std::string&) { lab.token_on_command_line = true; })
      ->group("");  // hidden: its message explains how to give a token
  command.add_flag("--no-open", lab.no_open, "open no browser; the address is printed");
  CLI::Option* exported =
      command
          .add_option("--export", lab.export_to,
                      "write one .html file with the page, the engine and the program, which needs "
                      "neither a network nor this command")
          ->type_name("FILE");
  command
      .add_option("--engine", lab.engine,
                  "the laboratory.html that --export is made of (default: the one of this command)")
      ->type_name("FILE")
      ->needs(exported);
  CLI::Option* inputs =
      command
          .add_option("--inputs", run.inputs,
                      "play the inputs of a .jsonl file instead of showing the page")
          ->type_name("FILE")
          ->needs(file);
  add_run_outputs(command, run, inputs);
}

int dispatch(int argc, char** argv) {
  CLI::App app(kLabHelp, "armlet lab");
  LabOptions lab;
  RunOptions options;
  add_lab_options(app, lab, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  if (!lab.export_to.empty() || options.record.ends_with(".html")) return save_lab(lab, options);
  return options.inputs.empty() ? serve_lab(lab, options) : run(options);
}

}  // namespace

int main(int argc, char** argv) { run_main(argc, argv, dispatch); }
