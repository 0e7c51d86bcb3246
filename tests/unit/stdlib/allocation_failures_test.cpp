// Programs that get no memory at one moment of their run, at every moment in turn.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/host.hpp"
#include "library.hpp"
#include "vm/state/state.hpp"

using namespace armlet;

namespace {

constexpr std::uint64_t kNever = UINT64_MAX;

std::vector<std::filesystem::path> programs() {
  std::vector<std::filesystem::path> found;
  for (const char* folder : {"tests/scripts", "examples"}) {
    const std::filesystem::path root = std::filesystem::path(ARMLET_ROOT) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (entry.path().extension() == ".rbt") found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

struct Run {
  RunResult result;
  std::uint64_t allocations = 0;
  std::uint64_t left = 0;  // bytes that nobody released
};

// Runs a program while the allocations from `first` on, `count` of them, are refused.
Run run(const std::shared_ptr<const Program>& program, std::uint64_t first, std::uint64_t count) {
  Host host({.robot = make_robot("scara")});
  VmOptions options;
  options.limits.steps = 20'000;
  options.limits.heap_bytes = 8U << 20U;
  options.timeline = &host;
  options.host = &host;
  options.output = [](std::string_view) {};
  Vm vm(program, std::move(options));
  vm.state().heap.refuse_from(first, count);
  Run run;
  run.result = vm.run();
  run.allocations = vm.state().heap.attempts();
  vm.state().clear();
  run.left = vm.state().heap.used();
  return run;
}

std::shared_ptr<const Program> compiled(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text(std::istreambuf_iterator<char>(file), {});
  Host host({.robot = make_robot("scara")});
  CompileOptions options;
  options.host = &host;
  return library_engine().compile(std::move(text), path.filename().string(), options).program;
}

}  // namespace

TEST_CASE("any allocation of any program may fail: a clean error, nothing left behind") {
  // The first ones and, of longer programs, every so many-th: fewer of those that take many steps,
  // all of them if asked for.
  const bool tries_all = std::getenv("ARMLET_EVERY_ALLOCATION") != nullptr;
  int programs_run = 0;
  int failed = 0;
  for (const std::filesystem::path& path : programs()) {
    const std::shared_ptr<const Program> program = compiled(path);
    if (program == nullptr) continue;
    ++programs_run;
    const Run whole = run(program, kNever, 0);
    const std::uint64_t all = whole.allocations;
    const std::uint64_t affordable = 1'000'000 / (whole.result.steps + 1);
    const std::uint64_t each = tries_all ? kNever : std::clamp<std::uint64_t>(affordable, 5, 25);
    for (std::uint64_t n = 1; n <= all; n += n <= each ? 1 : 1 + all / each) {
      for (const std::uint64_t count : {std::uint64_t{1}, kNever}) {
        const Run attempt = run(program, n, count);
        INFO(path.string() << ", allocation " << n << " of " << all);
        REQUIRE(attempt.left == 0);
        const bool is_clean = attempt.result.status == Progress::kDone ||
                              (attempt.result.error && !attempt.result.error->message.empty());
        REQUIRE(is_clean);
        if (attempt.result.error && attempt.result.error->code == "R0628") ++failed;
      }
    }
  }
  CHECK(programs_run > 50);
  CHECK(failed > programs_run);
}
