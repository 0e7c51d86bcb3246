#include "console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/install.hpp"
#include "files.hpp"
#include "imports.hpp"

namespace armlet::cli {
namespace {

std::atomic<Session*> running{nullptr};
std::atomic<bool> was_interrupted{false};

extern "C" void on_interrupt(int) {
  if (was_interrupted.exchange(true)) _exit(kStopped);
  if (Session* session = running.load()) session->cancel();
}

void write_error(std::string_view text) {
  std::fflush(stdout);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

// E0126 for a file as a whole.
void show_unreadable(const std::string& path, std::string_view reason, bool json) {
  const SourceSet none;
  show(make_diagnostic("E0126", kNoText, {path, std::string(reason)}), none, json);
}

}  // namespace

std::optional<std::string> read_file(const std::string& path, bool json) {
  std::string reason;
  std::optional<std::string> text = read_text(path, reason);
  if (!text) show_unreadable(path, reason, json);
  return text;
}

const Engine& engine() {
  static const Engine the_engine = [] {
    Engine made;
    install(made);
    return made;
  }();
  return the_engine;
}

Setup make_setup(const ProgramOptions& options, const std::string& file) {
  Setup setup;
  SessionOptions& session = setup.session;
  session.load = imports_of(file);
  session.robot = find_robot(options.robot);
  if (session.robot == nullptr) {
    setup.exit = kUsage;
    return setup;
  }
  if (options.world.empty()) {
    session.default_world = table_world();
  } else {
    auto text = read_file(options.world, options.json);
    if (!text) {
      setup.exit = kNoFile;
      return setup;
    }
    std::string name = options.world.substr(options.world.find_last_of('/') + 1);
    if (name.ends_with(".rbt")) name.resize(name.size() - 4);
    session.world = WorldText{std::move(name), *std::move(text)};
  }
  // What a program may write lies below its own folder.
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  session.folder = folder.empty() ? std::filesystem::path(".") : folder;
  session.limits.steps = options.steps;
  session.output = print_out;
  return setup;
}

void show(const Diagnostic& diagnostic, const SourceSet& sources, bool json) {
  if (json) {
    write_error(render_json(diagnostic, sources) + "\n");
  } else {
    write_error(render_text(diagnostic, sources, {.color = isatty(STDERR_FILENO) != 0}));
  }
}

void show(const std::vector<Problem>& problems, bool json) {
  for (const Problem& problem : problems) show(problem.diagnostic, *problem.sources, json);
}

void progress(std::string_view line) { write_error(fmt::format("{}\n", line)); }

void print_out(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

bool finish_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  write_error(fmt::format("armlet: what the program printed could not be written: {}\n",
                          std::strerror(errno)));
  return false;
}

Interruptible::Interruptible(Session& session) {
  was_interrupted = false;
  running = &session;
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Interruptible::~Interruptible() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  running = nullptr;
}

bool interrupted() { return was_interrupted; }

}  // namespace armlet::cli
