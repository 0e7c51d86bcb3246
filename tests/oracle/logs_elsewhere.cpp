// Runs of random programs, replayed from their logs by another process:
//   logs_elsewhere write FILE COUNT    runs COUNT programs with tasks and a quarter as many with
//                                      robots, with inputs of their host, and writes their logs
//   logs_elsewhere read FILE COUNT     replays each and compares its events with those in the log
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "armlet/backend/run_marks.hpp"
#include "armlet/core/random.hpp"
#include "armlet/interpreter/host/program_function.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "random/program.hpp"
#include "random/robot_program.hpp"

namespace armlet::oracle {
namespace {

SessionOptions options_of(RunMarks& marks) {
  SessionOptions options;
  options.robot = make_robot("scara");
  options.default_world = table_world();
  options.limits = {.steps = 20'000, .call_depth = 60};
  options.open = true;
  options.backends = {&marks};
  return options;
}

// What a host does to a run that has paused. What goes past the session is in no log and changes
// nothing.
void interfere(Session& session, Random& random) {
  session.set_signal("gate", random.below(2) == 0);
  if (random.below(3) == 0 && session.vm()->try_function<void(std::string, double)>("note")) {
    try {
      static_cast<void>(session.call("note", {Value("host"), Value(0.25, "rad")}));
    } catch (const ArgumentError&) {  // not all variables have values yet
    }
  }
  if (random.below(40) == 0) session.cancel();
}

std::optional<SessionLog> log_of_run(const std::string& text, std::uint64_t seed) {
  RunMarks marks;
  Session session(library_engine(), options_of(marks));
  if (!session.compile(text, "program.rbt")) return std::nullopt;
  Random random(seed);
  const auto slice = [&] {
    Budget budget{.until_ns = {}, .steps = 1 + random.below(400)};
    if (random.below(2) == 0 && session.host() != nullptr)
      budget.until_ns =
          session.host()->now_ns() + static_cast<std::int64_t>(random.below(50'000'000));
    return budget;
  };
  while (session.run(slice()) == Progress::kPaused)
    if (random.below(8) == 0) interfere(session, random);
  SessionLog log = session.log();
  log.marks = marks.marks();
  return log;
}

bool is_same_again(const SessionLog& log) {
  RunMarks marks;
  Session session(library_engine(), options_of(marks));
  if (!session.replay(log)) return false;
  static_cast<void>(session.run());
  const auto parting = where_runs_part(log.marks, marks.marks());
  return !parting && session.log().entries.front().end == log.entries.front().end;
}

std::string program(std::uint64_t number, std::uint64_t count) {
  return number <= count ? RandomProgram(number).with_tasks().text()
                         : RobotProgram(number - count).text();
}

int write(const char* file, std::uint64_t count) {
  std::ofstream out(file, std::ios::binary);
  std::uint64_t refused = 0;
  for (std::uint64_t number = 1; number <= count + count / 4; ++number) {
    const auto log = log_of_run(program(number, count), number);
    if (!log) {
      ++refused;
      continue;
    }
    const std::string bytes = write_log(*log).value();
    out << bytes.size() << '\n' << bytes;
  }
  fmt::print("{} programs, {} of them refused\n", count + count / 4, refused);
  return out.flush() && refused == 0 ? 0 : 1;
}

int read(const char* file, std::uint64_t count) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t logs = 0;
  std::uint64_t others = 0;
  for (std::size_t size = 0; in >> size && in.get() == '\n'; ++logs) {
    std::string bytes(size, '\0');
    if (!in.read(bytes.data(), static_cast<std::streamsize>(size))) break;
    const Result<SessionLog> log = read_log(bytes);
    if (log.ok() && is_same_again(*log)) continue;
    ++others;
    fmt::print("number {}: {}\n", logs + 1, log.ok() ? "another run" : log.error().message);
  }
  fmt::print("{} logs, {} of them of another run\n", logs, others);
  return logs == count + count / 4 && others == 0 ? 0 : 1;
}

}  // namespace
}  // namespace armlet::oracle

int main(int count, char** arguments) {
  const std::string mode = count == 4 ? arguments[1] : "";
  if (mode != "write" && mode != "read") {
    fmt::print(stderr, "logs_elsewhere write|read FILE COUNT\n");
    return 2;
  }
  const std::uint64_t programs = std::strtoull(arguments[3], nullptr, 10);
  return mode == "write" ? armlet::oracle::write(arguments[2], programs)
                         : armlet::oracle::read(arguments[2], programs);
}
