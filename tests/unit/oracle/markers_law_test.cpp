// Programs with markers do what those without do, also statement by statement.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "armlet/backend/run_hash.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "library.hpp"
#include "random/program.hpp"
#include "random/robot_program.hpp"
#include "runs.hpp"

using namespace armlet;
using namespace armlet::oracle;
using namespace armlet::runs;

namespace {

// What a run shows of itself.
struct MarkedRun {
  std::string output;
  std::string hash;
  std::string ending;
  std::uint64_t steps = 0;
  bool compiles = false;
  std::uint64_t statements = 0;
  bool operator==(const MarkedRun& other) const {
    return output == other.output && hash == other.hash && ending == other.ending &&
           steps == other.steps && compiles == other.compiles;
  }
};

// statements  in each slice.
MarkedRun run_marked(const std::string& text, const fs::path& folder, RunLimits limits,
                     bool markers, std::uint64_t statements = Budget::kNoLimit) {
  RunHash hash;
  MarkedRun shown;
  SessionOptions options = at_the_table();
  options.backends = {&hash};
  options.limits = limits;
  options.markers = markers;
  options.load = files_beside(folder);
  options.output = [&](std::string_view piece) {
    shown.output += piece;
    return std::string();
  };
  Session session(library_engine(), std::move(options));
  shown.compiles = session.compile(text, "program.rbt");
  if (!shown.compiles) return shown;
  while (session.run({.statements = statements}) == Progress::kPaused) {
    // Whatever is there can be looked at.
    std::size_t seen = 0;
    for (const SeenTask& task : seen_tasks(*session.vm())) {
      for (const SeenCall& call : task.calls) seen += call.variables.size();
    }
    CHECK(seen < 10'000);
  }
  const RunResult& result = session.result();
  shown.hash = hash.text();
  shown.steps = result.steps;
  if (result.error) shown.ending = result.error->code + " " + result.error->message;
  shown.statements = statements_begun(*session.vm());
  return shown;
}

void check_marked(const std::string& text, const fs::path& folder, RunLimits limits) {
  const MarkedRun without = run_marked(text, folder, limits, false);
  const MarkedRun with = run_marked(text, folder, limits, true);
  CHECK(with == without);
  if (!with.compiles) return;
  CHECK(run_marked(text, folder, limits, true, 1 + with.statements / 2000) == without);
}

void check_marked_files(const char* folder) {
  for (const fs::path& file : programs_below(folder)) {
    CAPTURE(file);
    check_marked(text_of(file), file.parent_path(), {.steps = 2'000'000});
  }
}

}  // namespace

TEST_CASE("examples do the same with markers, and statement by statement") {
  check_marked_files("examples");
}

TEST_CASE("scripts with tasks do the same with markers, and statement by statement") {
  check_marked_files("tests/scripts/tasks");
}

TEST_CASE("2,000 random programs do the same with markers, and statement by statement") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 2000);
  for (std::uint64_t number = first; number <= last; ++number) {
    CAPTURE(number);
    check_marked(RandomProgram(number).text(), {}, {.steps = 20'000, .call_depth = 60});
  }
}

TEST_CASE("random programs that move robots do the same with markers, and statement by statement") {
  for (std::uint64_t number = 1; number <= number_from("ARMLET_LAST", 40); ++number) {
    CAPTURE(number);
    check_marked(RobotProgram(number).text(), {}, {.steps = 200'000});
  }
}
