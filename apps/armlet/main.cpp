// The command: reads the command line and calls the sub-command.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "armlet/backend/trace_format.hpp"
#include "armlet/core/similar.hpp"
#include "console.hpp"
#include "embedded_texts.hpp"

namespace {

using namespace armlet::cli;

// Adds the option for packages whose meshes a description names.
void add_packages(CLI::App& command, std::vector<std::string>& packages) {
  command
      .add_option("--package", packages,
                  "where the meshes of package://NAME/... are (also along ROS_PACKAGE_PATH)")
      ->type_name("NAME=DIR")
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        const std::size_t equals = text.find('=');
        const bool good = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
        return good ? std::string() : "expected NAME=DIR, such as ur_description=../ur";
      });
}

std::string check_camera(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool good = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
  return good ? std::string() : "expected NAME=FOLDER, such as eye=recorded";
}

void add_program_options(CLI::App& command, ProgramOptions& options) {
  add_packages(command, options.packages);
  command
      .add_option("--robot", options.robot,
                  "the robot of programs that declare none (default: scara)")
      ->type_name("NAME");
  command
      .add_option(
          "--world", options.world,
          "the world: a .rbt file that declares objects, or a scene as GLB or URDF (default: a "
          "table with a cube and a cylinder)")
      ->type_name("FILE");
  command
      .add_option("--steps", options.steps,
                  "how many calls and loop passes a program may take (default: 10 billion)")
      ->type_name("N");
  command.add_flag("--json", options.json, "messages as JSON, one object per line");
}

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
  LabOptions lab;
  EditorOptions editor;
  FormatOptions format;
  RobotOptions robot;
  MeshOptions mesh;
  std::vector<std::string> files;
  std::string file;
  std::string code;
  std::string name;
  bool markdown = false;
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

// Adds the options for outputs of a run, for all commands that run a program to its end; `needed`
// is the option that makes a command one of them.
void add_run_outputs(CLI::App& command, Asked& asked, CLI::Option* needed) {
  std::vector<CLI::Option*> all;
  all.push_back(command
                    .add_option("--trace", asked.run.trace,
                                "write the run over time to a " + armlet::trace_endings() + " file")
                    ->type_name("FILE"));
  all.push_back(command
                    .add_option("--frames", asked.run.frames,
                                "write each picture that a camera takes to a PNG file in this "
                                "folder; a trace names the files")
                    ->type_name("FOLDER"));
  all.push_back(command
                    .add_option("--camera", asked.run.cameras,
                                "pictures of a camera from the PNG and JPEG files of a folder, in "
                                "the order of their names, instead of drawn ones")
                    ->type_name("NAME=FOLDER")
                    ->allow_extra_args(false)
                    ->check(check_camera));
  all.push_back(
      command.add_flag("--realtime", asked.run.realtime, "run no faster than the wall clock"));
  all.push_back(command.add_flag("--quiet", asked.run.quiet, "show no moves and no summary"));
  all.push_back(command.add_flag("--plots", asked.run.plots,
                                 "draw the figures of the program in the terminal"));
  all.push_back(command.add_flag("--hash", asked.run.hash,
                                 "print a number that tells runs apart, bit for bit"));
  all.push_back(command
                    .add_option("--storyboard", asked.run.storyboard,
                                "draw the cell at the end of each move, on one sheet, a .png file")
                    ->type_name("FILE"));
  all.push_back(command
                    .add_option("--video", asked.run.video,
                                "film the cell, 25 pictures a second of virtual time: an .mp4 or "
                                ".mkv file, or a folder for PNG files, such as frames/")
                    ->type_name("FILE"));
  all.push_back(command
                    .add_option("--record", asked.run.record,
                                "leave what `armlet replay` needs to take the run again in an "
                                ".arec file; of a laboratory also as a page, an .html file")
                    ->type_name("FILE"));
  for (CLI::Option* each : all) {
    // A laboratory without inputs can be recorded, too, as a page.
    if (needed != nullptr && each != all.back()) each->needs(needed);
  }
}

void add_run_options(CLI::App& command, Asked& asked) {
  command.add_option("FILE", asked.run.file, "the program")->required();
  add_program_options(command, asked.run.program);
  add_run_outputs(command, asked, nullptr);
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

void add_lab_options(CLI::App& command, Asked& asked) {
  LabOptions& lab = asked.lab;
  CLI::Option* file = command.add_option("FILE", asked.run.file, "the program");
  add_program_options(command, asked.run.program);
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
          .add_option("--inputs", asked.run.inputs,
                      "play the inputs of a .jsonl file instead of showing the page")
          ->type_name("FILE")
          ->needs(file);
  add_run_outputs(command, asked, inputs);
}

void add_explain_options(CLI::App& command, Asked& asked) {
  command.add_option("CODE", asked.code, "for example E0401; without it, all messages are listed");
}

void add_help_options(CLI::App& command, Asked& asked) {
  command.add_option("NAME", asked.name,
                     "for example moveL, or a word to look for; without it, all names");
  command.add_flag("--markdown", asked.markdown, "the whole reference, as in docs/stdlib.md");
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
    {"lab", "show a program, and what it does, in a browser", add_lab_options,
     [](const Asked& asked) {
       if (!asked.lab.export_to.empty() || asked.run.record.ends_with(".html"))
         return save_lab(asked.lab, asked.run);
       return asked.run.inputs.empty() ? serve_lab(asked.lab, asked.run) : run(asked.run);
     }},
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
     [](const Asked& asked) { return asked.lists ? lists() : help(asked.name, asked.markdown); }},
};

int dispatch(int argc, char** argv) {
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

// Exits without freeing the tables of the parser, since the system frees them faster.
[[noreturn]] void leave(int status) {
  end_as_others_do();
#ifdef __SANITIZE_ADDRESS__
  std::exit(status);  // so that leaks are found
#else
  std::fflush(nullptr);
  std::_Exit(status);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  prepare_process();
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
