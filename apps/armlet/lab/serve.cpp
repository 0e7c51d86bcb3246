// armlet lab: shows a program and everything that it does in browsers.

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <thread>
#include <utility>

#include "console.hpp"
#include "embedded_texts.hpp"
#include "lab/dropped_files.hpp"
#include "server/http_guard.hpp"
#include "server/server.hpp"

extern char** environ;

namespace armlet::cli {
namespace {

// Opens the address in the user's browser, where there is a screen.
void open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string command = "xdg-open";
  std::string argument = address;
  char* const arguments[] = {command.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1, 0);
  pid_t child = 0;
  const bool begun =
      posix_spawnp(&child, command.c_str(), &quiet, nullptr, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&quiet);
  if (begun) std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

int refuse(const std::string& why, int exit) {
  progress(fmt::format("armlet: {}", why));
  return exit;
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
  lab::ServerOptions server{.host = options.host,
                            .port = options.port,
                            .token = options.token.empty() ? lab::new_token() : options.token,
                            .page = lab::built_in_page(),
                            .on_ready = {},
                            .is_over = [] { return interrupted(); }};
  if (const std::string fault = lab::fault_of_token(server.token); !fault.empty())
    return refuse("--token: " + fault, kUsage);

  const std::string file = options.demo ? "demo.rbt" : run.file;
  std::optional<std::string> text =
      options.demo ? std::string(*embedded_texts("demo.rbt")) : read_file(file, run.program.json);
  if (!text) return kNoFile;
  Setup setup = make_setup(run.program, file);
  if (setup.exit != kDone) return setup.exit;
  const StayOnInterrupt guard;
  // The demonstration has no folder of its own.
  DroppedFiles dropped(setup.session.folder.string());
  std::function<Result<lab::KeptFile>(const std::string&, std::string)> keep;
  if (!options.demo) {
    keep = [&](const std::string& name, const std::string& bytes) {
      return dropped.keep(name, bytes);
    };
  }
  lab::Laboratory laboratory({.session = std::move(setup.session),
                              .file = file.substr(file.find_last_of('/') + 1),
                              .text = *std::move(text),
                              .version = ARMLET_VERSION,
                              .is_demo = options.demo,
                              .keep_file = std::move(keep)});
  server.on_ready = [&](const std::string& address) {
    print_out(address + "\n");
    finish_output();
    if (!options.no_open) open_browser(address);
  };
  const std::string why = lab::serve(laboratory, server);
  return why.empty() ? kDone : refuse(why, kFailed);
}

}  // namespace armlet::cli
