// The command: reads the command line and calls the sub-command.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "armlet/core/similar.hpp"
#include "commands.hpp"

namespace {

using namespace armlet::cli;

void add_program_options(CLI::App& command, ProgramOptions& options) {
  command
      .add_option("--robot", options.robot,
                  "the robot of programs that declare none (default: scara)")
      ->type_name("NAME");
  command
      .add_option("--world", options.world,
                  "a .rbt file that declares objects (default: a table with a cube and a cylinder)")
      ->type_name("FILE");
  command
      .add_option("--steps", options.steps,
                  "how many calls and loop passes a program may take (default: 10 billion)")
      ->type_name("N");
  command.add_flag("--json", options.json, "messages as JSON, one object per line");
}

// Whether the first word is a command; says so if not.
bool knows_command(const CLI::App& app, std::string_view word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) known.push_back(command->get_name());
  if (word.starts_with('-') || std::ranges::find(known, word) != known.end()) return true;
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  const std::string asked(word);
  std::fprintf(stderr, "armlet: there is no command \"%s\"; there are %s\n", asked.c_str(),
               list.c_str());
  const std::vector<std::string_view> names(known.begin(), known.end());
  if (word.ends_with(".rbt")) {
    std::fprintf(stderr, "to run a program, write armlet run %s\n", asked.c_str());
  } else if (const auto meant = armlet::most_similar(word, names)) {
    std::fprintf(stderr, "did you mean \"%s\"?\n", std::string(*meant).c_str());
  }
  return false;
}

CLI::App* add_run_command(CLI::App& app, RunOptions& options) {
  CLI::App* command = app.add_subcommand("run", "check a program and run it");
  command->add_option("FILE", options.file, "the program")->required();
  add_program_options(*command, options.program);
  command
      ->add_option("--trace", options.trace,
                   "write joints, hand and objects over time to a .csv or .jsonl file")
      ->type_name("FILE");
  command->add_flag("--realtime", options.realtime, "run no faster than the wall clock");
  command->add_flag("--quiet", options.quiet, "show no moves and no summary");
  command->add_flag("--plots", options.plots, "draw the figures of the program in the terminal");
  return command;
}

CLI::App* add_format_command(CLI::App& app, FormatOptions& options) {
  CLI::App* command = app.add_subcommand("fmt", "lay programs out, each in its file");
  command->add_option("FILE", options.files, "the programs; - for standard input and output")
      ->required();
  command->add_flag("--check", options.check,
                    "change nothing; name the files that would change and exit with 1");
  command->add_flag("--json", options.json, "messages as JSON, one object per line");
  return command;
}

CLI::App* add_robot_command(CLI::App& app, RobotOptions& options) {
  CLI::App* command = app.add_subcommand(
      "robot", "show the table of a ready robot: rows, limits, reach, kinematics");
  command->add_option("NAME", options.name,
                      "for example puma560, or a .urdf file; without it, all robots");
  CLI::Option* json = command->add_flag("--json", options.json, "as JSON, in metres and radians");
  CLI::Option* urdf = command->add_flag("--urdf", options.urdf, "as a robot description (URDF)");
  CLI::Option* block =
      command->add_flag("--rbt", options.block, "as a robot block for a program")->excludes(urdf);
  json->excludes(urdf)->excludes(block);
  command->add_option("--tip", options.tip, "of a .urdf file: the link at the end of the arm")
      ->type_name("LINK");
  command->add_flag("--published", options.published,
                    "of a .urdf file: keep inertias that no rigid body has");
  return command;
}

int dispatch(int argc, char** argv) {
  CLI::App app("Armlet: a small language for robot arms.");
  app.set_version_flag("--version", "armlet " ARMLET_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n  armlet run examples/01_pick_and_place.rbt\n  armlet explain E0401\n  armlet "
      "robot puma560\n\n"
      "Exit status: 0 ran, 1 to be laid out (fmt --check), 64 wrong usage, 65 program rejected, "
      "66 file not read, 70 program failed, 130 stopped.");

  RunOptions run_options;
  CLI::App* run_command = add_run_command(app, run_options);
  ProgramOptions options;
  std::vector<std::string> files;
  CLI::App* check_command = app.add_subcommand("check", "look for mistakes without running");
  check_command->add_option("FILE", files, "the programs")->required();
  add_program_options(*check_command, options);
  CLI::App* test_command =
      app.add_subcommand("test", "run the tests in programs, each in a fresh world");
  test_command->add_option("FILE", files, "the programs")->required();
  add_program_options(*test_command, options);
  std::string file;
  CLI::App* disasm_command =
      app.add_subcommand("disasm", "show the instructions that a program is compiled to");
  disasm_command->add_option("FILE", file, "the program")->required();
  add_program_options(*disasm_command, options);
  FormatOptions format_options;
  CLI::App* format_command = add_format_command(app, format_options);
  RobotOptions robot_options;
  CLI::App* robot_command = add_robot_command(app, robot_options);
  std::string code;
  CLI::App* explain_command =
      app.add_subcommand("explain", "say what a message means, with a wrong and a right program");
  explain_command->add_option("CODE", code,
                              "for example E0401; without it, all messages are listed");
  std::string name;
  bool markdown = false;
  CLI::App* help_command = app.add_subcommand("help", "say what a function does, with an example");
  help_command->add_option("NAME", name,
                           "for example moveL, or a word to look for; without it, all names");
  help_command->add_flag("--markdown", markdown, "the whole reference, as in docs/stdlib.md");

  if (argc > 1 && !knows_command(app, argv[1])) return kUsage;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  if (run_command->parsed()) return run(run_options);
  if (check_command->parsed()) return check(options, files);
  if (test_command->parsed()) return test(options, files);
  if (disasm_command->parsed()) return disasm(options, file);
  if (help_command->parsed()) return help(name, markdown);
  if (robot_command->parsed()) return robot(robot_options);
  if (format_command->parsed()) return format(format_options);
  return explain_command->parsed() ? explain(code) : kUsage;
}

// Ends without taking down the tables of the parser, which the system reclaims at once.
[[noreturn]] void leave(int status) {
#ifdef __SANITIZE_ADDRESS__
  std::exit(status);  // looks for leaks
#else
  std::fflush(nullptr);
  std::_Exit(status);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  int status = kFailed;
  try {
    status = dispatch(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("armlet: there is not enough memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "armlet: a defect of armlet itself: %s\n", error.what());
  }
  leave(status);
}
