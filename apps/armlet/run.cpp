// armlet run: check a program, run it, show each move, sum up.

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "armlet/backend/csv_backend.hpp"
#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/core/format.hpp"
#include "armlet/plot/braille.hpp"
#include "console.hpp"

namespace armlet::cli {
namespace {

// The trace file and the backend that writes it.
struct Trace {
  std::ofstream file;
  std::unique_ptr<Backend> backend;
};

// Nothing to say if there is no trace; the exit status after a message otherwise.
int open_trace(const std::string& path, Trace& trace) {
  if (path.empty()) return kDone;
  const bool csv = path.ends_with(".csv");
  if (!csv && !path.ends_with(".jsonl")) {
    progress(fmt::format("armlet: a trace is a .csv or .jsonl file, not \"{}\"", path));
    return kUsage;
  }
  trace.file.open(path, std::ios::binary | std::ios::trunc);
  if (!trace.file) {
    progress(fmt::format("armlet: the trace {} cannot be written: {}", path, std::strerror(errno)));
    return kNoFile;
  }
  if (csv) {
    trace.backend = std::make_unique<CsvBackend>(trace.file);
  } else {
    trace.backend = std::make_unique<JsonlBackend>(trace.file);
  }
  return kDone;
}

std::string seconds(double s) { return fmt::format("{:.2f} s", s); }

void show_move(const MoveReport& move) {
  const double end = move.start + move.duration;
  progress(fmt::format("[t = {}] {} {} {}{}, hand at {}", seconds(end), move.robot, move.function,
                       seconds(move.duration), move.stopped ? " (stopped)" : "",
                       format_point_mm(move.T_world_tool.translation())));
}

// Sleeps until wall-clock time has caught up with virtual time, in short pieces so that Ctrl-C is
// heard. Ctrl-C asks the program once to stop; coming to rest then costs no time.
std::function<bool(std::int64_t)> real_time() {
  const auto start = std::chrono::steady_clock::now();
  return [start, told = false](std::int64_t t_ns) mutable {
    const auto due = start + std::chrono::nanoseconds(t_ns);
    while (!interrupted() && std::chrono::steady_clock::now() < due) {
      std::this_thread::sleep_for(std::min<std::chrono::steady_clock::duration>(
          due - std::chrono::steady_clock::now(), std::chrono::milliseconds(20)));
    }
    return !interrupted() || std::exchange(told, true);
  };
}

void show_summary(const Session& session, const std::string& trace, RunStatus status) {
  const Host& host = *session.host();
  const char* how = status == RunStatus::kDone        ? "finished"
                    : status == RunStatus::kCancelled ? "stopped by the user"
                                                      : "ended by an error";
  progress(fmt::format("{} at t = {}, {} move{}", how, seconds(to_seconds(host.now_ns())),
                       host.move_count(), host.move_count() == 1 ? "" : "s"));
  const World& world = host.cell().world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    if (object.fixed) continue;
    std::string where = world.resting_on(object.name);
    if (const auto& held = world.attachment(object.name))
      where = fmt::format("held by {}", host.cell().robot(held->carrier).name);
    else if (!where.empty())
      where = "on " + where;
    progress(fmt::format("  {} at {}{}{}", object.name,
                         format_point_mm(object.T_world_obj.translation()),
                         where.empty() ? "" : ", ", where));
  }
  if (!trace.empty()) progress(fmt::format("  trace in {}", trace));
}

void draw_figures(const Session& session) {
  for (const Figure& figure : session.host()->figures()) {
    print_out("\n" + to_braille(figure, 72, 18, isatty(STDOUT_FILENO) != 0));
  }
}

}  // namespace

int run(const RunOptions& options) {
  const bool json = options.program.json;
  auto text = read_file(options.file, json);
  if (!text) return kNoFile;
  Setup setup = make_setup(options.program, options.file);
  if (setup.exit != kDone) return setup.exit;
  Trace trace;
  if (const int exit = open_trace(options.trace, trace); exit != kDone) return exit;
  if (trace.backend) setup.session.backends.push_back(trace.backend.get());
  if (options.realtime) setup.session.pace = real_time();
  const bool talks = !json && !options.quiet;
  if (talks) setup.session.on_move = show_move;
  const SourceSet* sources = nullptr;
  setup.session.advice = [&](const Diagnostic& d) { show(d, *sources, json); };

  Session session(engine(), std::move(setup.session));
  const bool runs = session.compile(*std::move(text), options.file);
  show(session.problems(), json);
  if (!runs) return kRejected;
  sources = &session.sources();

  RunResult result;
  {
    const Interruptible guard(session);
    result = session.run();
  }
  if (result.error) show(*result.error, session.sources(), json);
  if (options.plots) draw_figures(session);
  const bool written = finish_output();
  if (talks) show_summary(session, options.trace, result.status);
  if (trace.backend && !trace.backend->error().empty()) {
    progress(fmt::format("armlet: {}", trace.backend->error()));
    return kFailed;
  }
  if (result.status == RunStatus::kCancelled) return kStopped;
  return result.status == RunStatus::kDone && written ? kDone : kFailed;
}

}  // namespace armlet::cli
