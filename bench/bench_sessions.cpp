// What sessions of entries cost: memory of one that rests, and the time of an entry in a session
// with many variables.

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "bench.hpp"

using namespace armlet;

namespace {

constexpr int kSessions = 1000;

std::size_t allocated() { return mallinfo2().uordblks + mallinfo2().hblkhd; }

// With the stacks of tasks, and whatever the allocator keeps.
std::size_t resident() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

SessionOptions options() {
  SessionOptions made;
  made.robot = make_robot("scara");
  made.default_world = table_world();
  return made;
}

void enter(Session& session, const std::string& text) {
  if (session.submit(text, "line") && session.run().status == Progress::kDone) return;
  fmt::print("`{}` failed\n", text);
  std::exit(1);
}

void measure_memory() {
  std::vector<std::unique_ptr<Session>> sessions;
  const SessionOptions shared = options();
  enter(*std::make_unique<Session>(library_engine(), shared), "moveJ(home(), time: 1s)");
  const std::size_t none = allocated(), none_resident = resident();
  const auto per_session = [](std::size_t bytes) {
    return static_cast<double>(bytes) / kSessions / 1024.0;
  };
  const auto told = [&](const char* what) {
    fmt::print("{:<44} {:6.1f} kB, {:6.1f} kB resident\n", what, per_session(allocated() - none),
               per_session(resident() - none_resident));
  };
  for (int i = 0; i < kSessions; ++i) {
    sessions.push_back(std::make_unique<Session>(library_engine(), shared));
    enter(*sessions.back(), "let width = 40mm");
  }
  told("a session after one line");
  for (const auto& each : sessions)
    for (int line = 0; line < 10; ++line)
      enter(*each, fmt::format("let n{} = {} * width", line, line));
  told("after ten more");
  for (const auto& each : sessions) enter(*each, "moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  told("after a move");
}

void measure_entries() {
  Session session(library_engine(), options());
  enter(session, "moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  int count = 0;
  for (const int variables : {10, 300, 3000}) {
    std::string text;
    for (; count < variables; ++count) text += fmt::format("var v{} = [{}, 2, 3]\n", count, count);
    enter(session, text);
    constexpr int kEntries = 200;
    std::vector<double> rounds;
    const auto one = [&](int) {
      enter(session, "v1[0] += 1; v2[1]");
      return 0.0;
    };
    for (int round = 0; round < 7; ++round)
      rounds.push_back(bench::nanoseconds_per_call(kEntries, one));
    fmt::print("an entry of one line behind {:4} variables {:8.1f} us\n", variables,
               bench::median(rounds) * 1e-3);
  }
}

}  // namespace

int main() {
  measure_memory();
  measure_entries();
}
