#include "console/options.hpp"

#include <filesystem>
#include <system_error>

#include "armlet/backend/trace_format.hpp"

namespace armlet::cli {
namespace {

// Accepts NAME=VALUE.
CLI::Validator pair_like(const char* example) {
  return CLI::Validator(
      [example](const std::string& text) {
        const std::size_t equals = text.find('=');
        const bool good = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
        return good ? std::string() : std::string(example);
      },
      "");
}

// Accepts the path of a folder.
CLI::Validator not_empty(const char* what) {
  return CLI::Validator(
      [what](const std::string& text) {
        return text.empty() ? std::string("expected the name of ") + what : std::string();
      },
      "");
}

// Accepts the path of a file.
CLI::Validator path_like(const char* what) {
  return CLI::Validator(
      [what](const std::string& text) {
        const std::string name = text.substr(text.find_last_of('/') + 1);
        if (text.empty()) return std::string("expected the name of ") + what;
        std::error_code none;
        const bool is_ending = name.size() > 1 && name[0] == '.' && name.find('.', 1) == name.npos;
        return is_ending && !std::filesystem::is_directory(text, none)
                   ? "expected a name before " + name
                   : std::string();
      },
      "");
}

}  // namespace

void add_packages(CLI::App& command, std::vector<std::string>& packages) {
  command
      .add_option("--package", packages,
                  "where the meshes of package://NAME/... are (also along ROS_PACKAGE_PATH)")
      ->type_name("NAME=DIR")
      ->allow_extra_args(false)
      ->check(pair_like("expected NAME=DIR, such as ur_description=../ur"));
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

void add_run_outputs(CLI::App& command, RunOptions& run, CLI::Option* needed) {
  std::vector<CLI::Option*> all;
  all.push_back(command
                    .add_option("--trace", run.trace,
                                "write the run over time to a " + armlet::trace_endings() + " file")
                    ->type_name("FILE")
                    ->check(path_like("a file")));
  all.push_back(command
                    .add_option("--frames", run.frames,
                                "write each picture that a camera takes to a PNG file in this "
                                "folder; a trace names the files")
                    ->type_name("FOLDER")
                    ->check(not_empty("a folder")));
  all.push_back(command
                    .add_option("--camera", run.cameras,
                                "pictures of a camera from the PNG and JPEG files of a folder, in "
                                "the order of their names, instead of drawn ones")
                    ->type_name("NAME=FOLDER")
                    ->allow_extra_args(false)
                    ->check(pair_like("expected NAME=FOLDER, such as eye=recorded")));
  all.push_back(command.add_flag("--realtime", run.realtime, "run no faster than the wall clock"));
  all.push_back(command.add_flag("--quiet", run.quiet, "show no moves and no summary"));
  all.push_back(
      command.add_flag("--plots", run.plots, "draw the figures of the program in the terminal"));
  all.push_back(
      command.add_flag("--hash", run.hash, "print a number that tells runs apart, bit for bit"));
  all.push_back(command
                    .add_option("--storyboard", run.storyboard,
                                "draw the cell at the end of each move, on one sheet, a .png file")
                    ->type_name("FILE")
                    ->check(path_like("a .png file")));
  all.push_back(command
                    .add_option("--video", run.video,
                                "film the cell, 25 pictures a second of virtual time: an .mp4 or "
                                ".mkv file, or a folder for PNG files, such as frames/")
                    ->type_name("FILE")
                    ->check(path_like("a video, or of a folder")));
  all.push_back(command
                    .add_option("--record", run.record,
                                "leave what `armlet replay` needs to take the run again in an "
                                ".arec file; of a laboratory also as a page, an .html file")
                    ->type_name("FILE")
                    ->check(path_like("an .arec file")));
  for (CLI::Option* each : all) {
    // A laboratory without inputs can be recorded, too, as a page.
    if (needed != nullptr && each != all.back()) each->needs(needed);
  }
}

}  // namespace armlet::cli
