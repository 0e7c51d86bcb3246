// armlet lab: shows a program and its runs in browsers.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "console/console.hpp"
#include "console/setup.hpp"
#include "embedded_demo.hpp"
#include "lab/browser.hpp"
#include "lab/dropped_files.hpp"
#include "lab/lab.hpp"
#include "lab/program_on_disk.hpp"
#include "lab/token.hpp"
#include "server/http_guard.hpp"
#include "server/server.hpp"

namespace armlet::cli {
namespace {

int refuse(const std::string& why, int exit) {
  progress(fmt::format("armlet: {}", why));
  return exit;
}

// The text with which the laboratory starts, and whether the file exists.
struct Start {
  std::string text;
  bool exists = true;
};

// A program that does not exist starts from a template if its folder exists and its name is that of
// a program. nullopt: the file cannot be read, which was reported.
std::optional<Start> start_of(const LabOptions& options, const RunOptions& run) {
  if (options.demo) return Start{std::string(*embedded_demo("demo.rbt")), false};
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::absolute(run.file, ignored);
  if (path.extension() == ".rbt" && !std::filesystem::exists(path, ignored) &&
      std::filesystem::is_directory(path.parent_path(), ignored)) {
    progress(fmt::format("armlet: {} does not exist yet: the first save in the page makes it",
                         run.file));
    return Start{std::string(*embedded_demo("arm.rbt")), false};
  }
  std::optional<std::string> text = read_file(run.file, run.program.json);
  if (!text) return std::nullopt;
  return Start{*std::move(text), true};
}

// The file that pages may read and write: only this one. None for the demonstration program and for
// a program from a pipe.
lab::ProgramFile program_file(const Start& start, const std::string& file) {
  if (start.exists && !is_file(file)) return {};
  Result<ProgramOnDisk> opened = ProgramOnDisk::open(file);
  if (!opened.ok()) return {};
  const auto disk = std::make_shared<ProgramOnDisk>(std::move(opened).value());
  return {.exists = start.exists,
          .read = [disk] { return disk->read(); },
          .write = [disk](const std::string& text) { return disk->write(text); }};
}

}  // namespace

int serve_lab(const LabOptions& options, const RunOptions& run) {
  if (run.file.empty() && !options.demo)
    return refuse("which program? armlet lab FILE, or armlet lab --demo", kUsage);
  if (!run.record.empty())
    return refuse(
        "a laboratory that is shown is recorded as a page, an .html file; an .arec file needs "
        "--inputs",
        kUsage);
  const GivenToken given = given_token(options);
  if (!given.fault.empty()) return refuse(given.fault, given.exit);
  lab::ServerOptions server{.host = options.host,
                            .port = options.port,
                            .token = given.token.empty() ? lab::new_token() : given.token,
                            .page = lab::built_in_page(),
                            .on_ready = {},
                            .is_over = [] { return interrupted(); }};

  const std::string file = options.demo ? "demo.rbt" : run.file;
  const std::optional<Start> start = start_of(options, run);
  if (!start) return kNoFile;
  Setup setup = make_setup(run.program, file);
  if (setup.exit != kDone) return setup.exit;
  const StayOnInterrupt guard;
  // The demonstration program has no folder.
  DroppedFiles dropped(setup.session.folder.string());
  std::function<Result<lab::KeptFile>(const std::string&, std::string)> keep;
  if (!options.demo) {
    keep = [&](const std::string& name, const std::string& bytes) {
      return dropped.keep(name, bytes);
    };
  }
  lab::Laboratory laboratory(
      {.session = std::move(setup.session),
       .file = file.substr(file.find_last_of('/') + 1),
       .text = start->text,
       .version = ARMLET_VERSION,
       .is_demo = options.demo,
       .keep_file = std::move(keep),
       .program_file = options.demo ? lab::ProgramFile{} : program_file(*start, file)});
  BrowserOpener browser;
  server.on_ready = [&](const std::string& address) {
    for (const std::string& warning : {given.warning, warning_of_host(options.host)})
      if (!warning.empty()) progress("armlet: " + warning);
    print_out(address + "\n");
    finish_output();
    if (!options.no_open) browser.open(address);
  };
  const std::string why = lab::serve(laboratory, server);
  return why.empty() ? kDone : refuse(why, kFailed);
}

}  // namespace armlet::cli
