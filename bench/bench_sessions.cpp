// The cost of sessions: memory of an idle one, the time of an entry and of a completion list in a
// long session, of slices, and of going to any time of a run of five minutes.

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "bench.hpp"

using namespace armlet;

namespace {

constexpr int kSessions = 1000;

std::size_t allocated() { return mallinfo2().uordblks + mallinfo2().hblkhd; }

// The memory of the process, including stacks of tasks and memory kept by the allocator.
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

// The time of an entry after many others.
void measure_entries() {
  Session session(library_engine(), options());
  enter(session, "moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  enter(session, "var v1 = [1, 2, 3]\nvar v2 = [4, 5, 6]");
  int count = 0;
  for (const int lines : {10, 300, 3000, 10'000}) {
    for (; count < lines; ++count) enter(session, fmt::format("var w{} = {}", count, count));
    constexpr int kEntries = 200;
    std::vector<double> rounds;
    const auto one = [&](int) {
      enter(session, "v1[0] += 1; v2[1]");
      return 0.0;
    };
    for (int round = 0; round < 7; ++round)
      rounds.push_back(bench::nanoseconds_per_call(kEntries, one));
    fmt::print("an entry of one line behind {:5} others      {:10.1f} us  (target 1,000)\n", lines,
               bench::median(rounds) * 1e-3);
  }
}

// The time from a key to its completion list, as in the prompt, after a thousand lines.
void measure_completion() {
  Session session(library_engine(), options());
  for (int i = 0; i < 1000; ++i) enter(session, fmt::format("let name{} = {}mm", i, i));
  std::vector<double> rounds;
  std::size_t offered = 0;
  const auto key = [&](int) {
    const std::string line = "moveL(xyz(name1";
    const auto at = static_cast<std::uint32_t>(line.size());
    offered = session.analyse(line, "line")->completion(at).items.size();
    return static_cast<double>(offered);
  };
  for (int round = 0; round < 11; ++round) rounds.push_back(bench::nanoseconds_per_call(5, key));
  fmt::print("a key to its list of {} names {:18.2f} ms  (target 10)\n", offered,
             bench::median(rounds) * 1e-6);
}

std::string text_of(const std::string& name) {
  std::ifstream file(ARMLET_BENCH "/programs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Runs a program that was compiled before, in slices.
double run_through(Session& session, const Budget& slice) {
  std::int64_t now = 0;
  std::size_t slices = 0;
  Budget budget = slice;
  do {
    if (slice.until_ns) budget.until_ns = now + *slice.until_ns;
    ++slices;
    const Progress progress = session.run(budget);
    now = session.host()->now_ns();
    if (progress == Progress::kDone) return static_cast<double>(slices);
    if (progress == Progress::kPaused) continue;
    fmt::print("the program failed\n");
    std::exit(1);
  } while (true);
}

void measure_slices(const std::string& name) {
  Session session(library_engine(), options());
  if (!session.compile(text_of(name), name)) std::exit(1);
  const auto whole = [&](int) { return run_through(session, {}); };
  const auto row = [&](const char* what, const Budget& slice) {
    double slices = 0.0;
    const auto cut = [&](int) { return slices = run_through(session, slice); };
    const bench::Times times = bench::compare(1, cut, whole, 15);
    fmt::print("{:<30} {:<18} {:7.0f} slices {:8.2f} ms, in one {:8.2f} ms: {:+5.1f} %\n", name,
               what, slices, times.ours * 1e-6, times.theirs * 1e-6,
               100.0 * (times.ours / times.theirs - 1.0));
  };
  row("4,096 steps", {.steps = 4096});
  row("1/60 s", {.until_ns = 16'666'667});
  row("1 ms", {.until_ns = 1'000'000});
}

void measure_going() {
  Session session(library_engine(), options());
  if (!session.compile(text_of("motion/five_minutes.rbt"), "five_minutes.rbt")) std::exit(1);
  static_cast<void>(run_through(session, {}));
  const std::int64_t end_ns = session.host()->now_ns();
  Random random(1);
  std::vector<double> times;
  for (int i = 0; i < 20; ++i) {
    const auto t_ns = i == 0 ? end_ns : static_cast<std::int64_t>(random.below(end_ns));
    const auto go = [&](int) {
      if (!session.go_to(t_ns)) std::exit(1);
      return 1.0;
    };
    times.push_back(bench::nanoseconds_per_call(1, go));
  }
  fmt::print(
      "going to 20 instants of {:.0f} s of pick and place: median {:.0f} ms, largest {:.0f} ms  "
      "(target 300)\n",
      static_cast<double>(end_ns) * 1e-9, bench::median(times) * 1e-6,
      *std::ranges::max_element(times) * 1e-6);
}

}  // namespace

int main() {
  measure_memory();
  measure_entries();
  measure_completion();
  for (const char* name : {"motion/pick_and_place.rbt", "rbt/fib.rbt", "rbt/nbody.rbt"})
    measure_slices(name);
  measure_going();
}
