// armlet replay: runs a recorded run again, to compare it with the record, or up to a time.

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "armlet/backend/run_marks.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/core/files.hpp"
#include "armlet/core/format.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/stdlib/install.hpp"
#include "console/console.hpp"
#include "console/setup.hpp"
#include "run/run_report.hpp"

namespace armlet::cli {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 28U;

// The log in the file, or the exit status after a message.
struct ReadRecord {
  SessionLog log;
  int exit = kDone;
};

ReadRecord read_record(const std::string& path) {
  const auto refuse = [&](const std::string& why, int exit) {
    progress(fmt::format("armlet: {} cannot be replayed: {}", path, why));
    return ReadRecord{{}, exit};
  };
  const Result<std::string> bytes = armlet::read_file(path, kMostBytes);
  if (!bytes.ok()) return refuse(bytes.error().message, kNoFile);
  Result<SessionLog> log = read_log(*bytes);
  if (!log.ok()) return refuse(log.error().message, kRejected);
  return {std::move(log).value()};
}

SessionOptions options_of(const SessionLog& log) {
  SessionOptions options;
  if (!log.robot.empty()) options.robot = find_robot(log.robot);
  options.world = log.world;
  options.default_world = log.default_world;
  options.limits = log.limits;
  options.open = log.open;
  options.frames.cameras = log.frames;
  options.laboratory = log.laboratory;
  return options;
}

// ---- the state of the cell

void show_robots(const Cell& cell) {
  for (int i = 0; i < cell.robot_count(); ++i) {
    const CellRobot& robot = cell.robot(i);
    std::string joints;
    for (int j = 0; j < robot.model->n(); ++j) {
      const bool turns = robot.model->is_revolute(j);
      joints += (j == 0 ? "" : ", ") + (turns ? format_deg(robot.q[j]) : format_mm(robot.q[j]));
    }
    print_out(fmt::format("robot {} at {}, {}\n  joints {}\n", robot.name,
                          format_point_mm(cell.T_world_tool(i).translation()),
                          robot.motion ? "moving" : "at rest", joints));
    if (!robot.held.empty()) print_out(fmt::format("  holds {}\n", robot.held));
  }
}

void show_objects(const World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    if (object.fixed) continue;
    const std::string on = world.resting_on(object.name);
    print_out(fmt::format("object {} at {}{}\n", object.name,
                          format_point_mm(object.T_world_obj.translation()),
                          on.empty() ? "" : ", on " + on));
  }
}

void show_signals(const Signals& signals) {
  for (const auto& [name, value] : signals.all()) {
    const bool* on = std::get_if<bool>(&value);
    print_out(fmt::format("signal {} = {}\n", name,
                          on == nullptr ? format_number(std::get<double>(value), 9)
                                        : std::string(*on ? "true" : "false")));
  }
}

void show_variable(std::string_view before, const SeenVariable& variable) {
  print_out(fmt::format("{}{}: {}{}\n", before, variable.name, variable.type,
                        variable.value.empty() ? ", not set" : " = " + variable.value));
}

void show_program(Session& session) {
  const SourceSet& sources = session.sources();
  for (const SeenVariable& each : seen_variables(*session.vm())) {
    show_variable("", each);
  }
  for (const SeenTask& task : seen_tasks(*session.vm())) {
    std::string line = task.name.empty() ? "the program" : task.name;
    if (!task.calls.empty())
      line += fmt::format(", line {}", sources.position(task.calls.front().at).line);
    if (!task.waits.empty()) line += ", waits for " + task.waits;
    print_out(line + "\n");
    for (const SeenCall& call : task.calls) {
      if (!call.function.empty() && &call != &task.calls.back())
        print_out(fmt::format("  in {}\n", call.function));
      for (const SeenVariable& each : call.variables) show_variable("    ", each);
    }
  }
}

int show_instant(Session& session, std::int64_t t_ns) {
  try {
    if (!session.go_to(t_ns)) return kStopped;
  } catch (const ArgumentError& error) {
    progress(fmt::format("armlet: {}", error.what()));
    return kUsage;
  }
  const Host& host = *session.host();
  print_out(fmt::format("t = {} s\n", format_number(to_seconds(host.now_ns()), 9)));
  show_robots(host.cell());
  show_objects(host.cell().world());
  show_signals(host.cell().signals());
  show_program(session);
  return finish_output() ? kDone : kFailed;
}

// ---- comparison

int compare(const SessionLog& log, const RunMarks& marks) {
  const auto parting = where_runs_part(log.marks, marks.marks());
  if (!parting) {
    print_out(fmt::format("the same run, hash {}\n", marks.text()));
    return finish_output() ? kDone : kFailed;
  }
  const auto time = [](std::int64_t t_ns) { return format_number(to_seconds(t_ns), 9); };
  progress(
      fmt::format("armlet: this is another run than the one that was recorded: they are the "
                  "same until t = {} s, and not at t = {} s",
                  time(parting->same_ns), time(parting->differ_ns)));
  return kFailed;
}

// Runs one entry after the other.
RunResult run_all(Session& session, const SessionLog& log) {
  RunResult result;
  std::size_t to_come = 0;
  do {
    to_come = session.to_come();
    result = session.run();
    if (session.is_at_rest()) {  // a laboratory: its inputs come later
      session.run({.until_ns = log.entries.front().end.t_ns});
      session.finish();
      result = session.result();
    }
  } while (session.to_come() > 0 && session.to_come() < to_come && !interrupted());
  return result;
}

}  // namespace

int replay(const ReplayOptions& options) {
  ReadRecord record = read_record(options.file);
  if (record.exit != kDone) return record.exit;
  const SessionLog& log = record.log;
  if (options.verify && log.marks.empty()) {
    progress(fmt::format("armlet: {} holds no hashes to compare with", options.file));
    return kRejected;
  }
  std::optional<std::int64_t> to_ns;
  if (!options.to.empty() && !(to_ns = time_of(options.to))) {
    progress(fmt::format("armlet: --to takes a time from 0 to 100 years, such as 3.2s, not \"{}\"",
                         options.to));
    return kUsage;
  }

  SessionOptions setup = options_of(log);
  if (!log.robot.empty() && setup.robot == nullptr) return kRejected;
  RunMarks marks;
  const bool is_heard = !options.verify && !to_ns;
  if (options.verify) setup.backends = {&marks};
  if (to_ns) setup.open = setup.markers = true;  // to show the variables
  const Session* replayed = nullptr;
  if (is_heard) {
    setup.output = [](std::string_view text) {
      print_out(text);
      return std::string();
    };
    setup.advice = [&](const Diagnostic& d) { show(d, replayed->sources(), options.json); };
    if (!options.json && !options.quiet) setup.on_move = show_move;
  }
  Session session(library_engine(), std::move(setup));
  replayed = &session;
  const bool runs = session.replay(log);
  if (is_heard || !runs) show(session.problems(), options.json);
  if (!runs) return kRejected;
  const Interruptible guard(session);
  if (to_ns) return show_instant(session, *to_ns);

  const RunResult result = run_all(session, log);
  if (interrupted()) return kStopped;
  if (options.verify) return compare(log, marks);
  if (result.error && output_is_read()) show(*result.error, session.sources(), options.json);
  const bool written = finish_output();
  if (!options.json && !options.quiet && output_is_read()) show_summary(session, {}, result.status);
  if (result.status == Progress::kCancelled) return kStopped;
  return result.status == Progress::kDone && written ? kDone : kFailed;
}

}  // namespace armlet::cli
