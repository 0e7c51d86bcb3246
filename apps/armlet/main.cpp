// The command: reads the command line and calls the sub-command.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "armlet/core/platform.hpp"
#include "armlet/core/similar.hpp"
#include "console/console.hpp"
#include "console/options.hpp"
#include "embedded_texts.hpp"

namespace {

using namespace armlet::cli;

// Whether the first word is a command; prints a message if not.
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

// The contents of the command line.
struct Asked {
  ProgramOptions options;
  PromptOptions prompt;
  RunOptions run;
  ReplayOptions replay;
  EditorOptions editor;
  FormatOptions format;
  RobotOptions robot;
  MeshOptions mesh;
  std::vector<std::string> files;
  std::string file;
  std::string code;
  std::string name;
  HelpQuestion help;
  std::vector<std::string> help_words;
  bool lists = false;
};

void add_prompt_options(CLI::App& app, Asked& asked) {
  app.add_option("--robot", asked.prompt.program.robot, "of the prompt: the robot (default: scara)")
      ->type_name("NAME");
  app.add_option(
         "--world", asked.prompt.program.world,
         "of the prompt: the world, a .rbt file that declares objects, or a scene as GLB or "
         "URDF (default: a table with a cube and a cylinder)")
      ->type_name("FILE");
  app.add_option("--record", asked.prompt.record,
                 "of the prompt: leave what `armlet replay` needs to take the session again in an "
                 ".arec file")
      ->type_name("FILE");
}

void add_run_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.run.file, "the program")->required();
  add_program_options(command, asked.run.program);
  add_run_outputs(command, asked.run, nullptr);
}

void add_replay_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.replay.file, "a record of a run (.arec)")->required();
  CLI::Option* verify = command.add_flag(
      "--verify", asked.replay.verify,
      "print nothing of the program; compare with the run that was recorded, event by event");
  command
      .add_option("--to", asked.replay.to,
                  "go to a time, such as 3.2s, and show robots, objects and variables")
      ->type_name("TIME")
      ->excludes(verify);
  command.add_flag("--quiet", asked.replay.quiet, "show no moves and no summary");
  command.add_flag("--json", asked.replay.json, "messages as JSON, one object per line");
}

void add_files_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.files, "the programs")->required();
  add_program_options(command, asked.options);
}

void add_disasm_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.file, "the program")->required();
  add_program_options(command, asked.options);
}

void add_format_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.format.files, "the programs; - for standard input and output")
      ->required();
  command.add_flag("--check", asked.format.check,
                   "change nothing; name the files that would change and exit with 1");
  command.add_flag("--json", asked.format.json, "messages as JSON, one object per line");
}

void add_editor_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.editor.file, "the program")->required();
  command.add_option("LINE:COLUMN", asked.editor.position, "counted from 1, columns in characters")
      ->required();
  add_program_options(command, asked.editor.program);
}

void add_robot_options(CLI::App& command, Asked& asked) {
  command.add_option("NAME", asked.robot.name,
                     "for example puma560, or a .urdf file; without it, all robots");
  CLI::Option* json =
      command.add_flag("--json", asked.robot.json, "as JSON, in metres and radians");
  CLI::Option* urdf = command.add_flag("--urdf", asked.robot.urdf, "as a robot description (URDF)");
  CLI::Option* block =
      command.add_flag("--rbt", asked.robot.block, "as a robot block for a program")
          ->excludes(urdf);
  CLI::Option* glb = command
                         .add_option_function<std::string>(
                             "--glb",
                             [&asked](const std::string& file) {
                               asked.robot.glb = true;
                               asked.robot.glb_file = file;
                             },
                             "its shapes, as the page draws them, as a GLB file (default: to "
                             "standard output)")
                         ->type_name("FILE")
                         ->expected(0, 1)
                         ->excludes(urdf)
                         ->excludes(block);
  json->excludes(urdf)->excludes(block)->excludes(glb);
  command.add_option("--tip", asked.robot.tip, "of a .urdf file: the link at the end of the arm")
      ->type_name("LINK");
  command.add_flag("--published", asked.robot.published,
                   "of a .urdf file: keep inertias that no rigid body has");
  add_packages(command, asked.robot.packages);
}

void add_mesh_options(CLI::App& command, Asked& asked) {
  MeshOptions& mesh = asked.mesh;
  command.require_subcommand(1);
  CLI::App* convert = command.add_subcommand(
      "convert", "make a GLB of a mesh, with its colours and pictures inside");
  convert->add_option("IN", mesh.from, "OBJ, 3DS, VRML 2.0 (.wrl), STL, DAE, PLY, glTF or GLB")
      ->required();
  convert->add_option("OUT", mesh.to, "a .glb file, which is replaced if it is there")->required();
  convert
      ->add_option("--unit", mesh.unit,
                   "the length of one unit of IN, for example 1mm (default: as its format says; 1m "
                   "for OBJ, 3DS, STL and PLY, which say nothing)")
      ->type_name("LENGTH");
  convert
      ->add_option(
          "--up", mesh.up,
          "the axis of IN that points up (default: as its format says; z for OBJ, 3DS, STL "
          "and PLY, which say nothing)")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"y", "z"}));
  convert->add_flag("--quiet", mesh.quiet, "say nothing but what is wrong");
}

void add_explain_options(CLI::App& command, Asked& asked) {
  command.add_option("CODE", asked.code, "for example E0401; without it, all messages are listed");
}

void add_help_options(CLI::App& command, Asked& asked) {
  command.add_option("NAME", asked.help_words,
                     "for example moveL, or words to look for; without it, all names");
  command.add_flag("--all", asked.help.whole, "all forms of a function, all pages with the words");
  command.add_flag("--markdown", asked.help.markdown, "the whole reference, as in docs/stdlib.md");
  command.add_flag("--lists", asked.lists,
                   "all words, units, functions, robots, planners and traces, as JSON");
}

struct Command {
  const char* name;
  const char* help;
  void (*add_options)(CLI::App& command, Asked& asked);
  int (*run)(const Asked& asked);
};

constexpr Command kCommands[] = {
    {"run", "check a program and run it", add_run_options,
     [](const Asked& asked) { return run(asked.run); }},
    {"replay", "take a recorded run again, or go to a time of it", add_replay_options,
     [](const Asked& asked) { return replay(asked.replay); }},
    {"check", "look for mistakes without running", add_files_options,
     [](const Asked& asked) { return check(asked.options, asked.files); }},
    {"lab", kLabHelp, nullptr, nullptr},  // a program of its own: start_lab
    {"test", "run the tests in programs, each in a fresh world", add_files_options,
     [](const Asked& asked) { return test(asked.options, asked.files); }},
    {"disasm", "show the instructions that a program is compiled to", add_disasm_options,
     [](const Asked& asked) { return disasm(asked.options, asked.file); }},
    {"fmt", "lay programs out, each in its file", add_format_options,
     [](const Asked& asked) { return format(asked.format); }},
    {"complete", "list what can be written at a position of a program", add_editor_options,
     [](const Asked& asked) { return complete(asked.editor); }},
    {"hover", "say what stands at a position of a program", add_editor_options,
     [](const Asked& asked) { return hover(asked.editor); }},
    {"robot", "show the table of a ready robot: rows, limits, reach, kinematics", add_robot_options,
     [](const Asked& asked) { return robot(asked.robot); }},
    {"mesh", "make a GLB of a mesh in another format", add_mesh_options,
     [](const Asked& asked) { return convert_mesh(asked.mesh); }},
    {"explain", "say what a message means, with a wrong and a right program", add_explain_options,
     [](const Asked& asked) { return explain(asked.code); }},
    {"help", "say what a function does, with an example", add_help_options,
     [](const Asked& asked) {
       HelpQuestion question = asked.help;
       question.name = fmt::format("{}", fmt::join(asked.help_words, " "));
       return asked.lists ? lists() : help(question);
     }},
};

// Becomes the program armlet-lab, with the arguments after `armlet lab`.
int start_lab(char** arguments) {
  const std::string program = armlet::program_folder() + "/armlet-lab";
  std::string name = "armlet lab";
  std::vector<char*> all{name.data()};
  while (*arguments != nullptr) all.push_back(*arguments++);
  all.push_back(nullptr);
  execv(program.c_str(), all.data());
  const char* why = std::strerror(errno);
  std::fprintf(stderr, "armlet: laboratories are shown by %s, which cannot be started: %s\n",
               program.c_str(), why);
  std::fputs("in the source tree `./dev build` makes it; it belongs beside armlet\n", stderr);
  return kNoFile;
}

int dispatch(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "lab") return start_lab(argv + 2);
  CLI::App app("Armlet: a small language for robot arms. Without a command: the prompt.");
  app.set_version_flag("--version", "armlet " ARMLET_VERSION);
  bool notices = false;
  app.add_flag("--notices", notices, "Print the software of others in it, with its licences");
  app.require_subcommand(0, 1);
  app.footer(
      "Examples:\n  armlet run examples/01_pick_and_place.rbt\n  armlet explain E0401\n  armlet "
      "robot puma560\n\n"
      "Exit status: 0 ran, 1 to be laid out (fmt --check), 64 wrong usage, 65 program rejected, "
      "66 file not read, 70 program failed, 130 stopped.");

  Asked asked;
  const Command* wanted = nullptr;
  const bool prompts = argc < 2 || std::string_view(argv[1]).starts_with('-');
  if (prompts) add_prompt_options(app, asked);
  for (const Command& command : kCommands) {
    CLI::App* known = app.add_subcommand(command.name, command.help);
    if (argc < 2 || command.name != std::string_view(argv[1])) continue;
    command.add_options(*known, asked);  // only the options of this command, to start sooner
    wanted = &command;
  }
  if (argc > 1 && !knows_command(app, argv[1])) return kUsage;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  if (wanted != nullptr) return wanted->run(asked);
  if (notices) {
    print_out(*armlet::embedded_texts("NOTICE"));
    return finish_output() ? kDone : kFailed;
  }
  return prompts ? prompt(asked.prompt) : kUsage;
}

}  // namespace

int main(int argc, char** argv) { run_main(argc, argv, dispatch); }
