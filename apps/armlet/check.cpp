// armlet check and armlet test.

#include <fmt/format.h>

#include <algorithm>

#include "armlet/stdlib/install.hpp"
#include "console/console.hpp"
#include "console/setup.hpp"

namespace armlet::cli {

int check(const ProgramOptions& options, const std::vector<std::string>& files) {
  int exit = kDone;
  for (const std::string& file : files) {
    auto text = read_file(file, options.json);
    if (!text) {
      exit = std::max<int>(exit, kNoFile);
      continue;
    }
    Setup setup = make_setup(options, file);
    if (setup.exit != kDone) return setup.exit;
    Session session(library_engine(), std::move(setup.session));
    const bool good = session.compile(*std::move(text), file);
    show(session.problems(), options.json);
    if (!good) exit = std::max<int>(exit, kRejected);
    if (good && !options.json) progress(fmt::format("{}: no mistakes found", file));
  }
  return exit;
}

namespace {

struct Count {
  int tests = 0;
  int failed = 0;
};

// Runs one test in a fresh world; its messages follow its line.
void run_one(Session& session, std::size_t index, const std::string& name, bool json,
             Count& count) {
  const RunResult result = session.run_test(index);
  ++count.tests;
  const bool passed = result.status == Progress::kDone;
  if (!passed) ++count.failed;
  if (!json) print_out(fmt::format("  {}  {}\n", passed ? "ok  " : "FAIL", name));
  if (result.error) show(*result.error, session.sources(), json);
}

int test_file(const ProgramOptions& options, const std::string& file, Count& count) {
  auto text = read_file(file, options.json);
  if (!text) return kNoFile;
  Setup setup = make_setup(options, file);
  if (setup.exit != kDone) return setup.exit;
  const SourceSet* sources = nullptr;
  setup.session.advice = [&](const Diagnostic& d) { show(d, *sources, options.json); };
  Session session(library_engine(), std::move(setup.session));
  const bool good = session.compile(*std::move(text), file);
  show(session.problems(), options.json);
  if (!good) return kRejected;
  sources = &session.sources();
  const Interruptible guard(session);
  const std::vector<std::string> names = session.program()->test_names();
  if (!options.json) print_out(fmt::format("{}\n", file));
  for (std::size_t i = 0; i < names.size() && !interrupted(); ++i)
    run_one(session, i, names[i], options.json, count);
  return interrupted() ? kStopped : kDone;
}

}  // namespace

int test(const ProgramOptions& options, const std::vector<std::string>& files) {
  Count count;
  int exit = kDone;
  for (const std::string& file : files) {
    const int result = test_file(options, file, count);
    if (result == kStopped || result == kUsage) return result;
    exit = std::max(exit, result);
  }
  if (!options.json)
    print_out(fmt::format("{} test{}, {} failed\n", count.tests, count.tests == 1 ? "" : "s",
                          count.failed));
  if (!finish_output()) return kFailed;
  if (exit == kDone && count.failed > 0) exit = kFailed;
  return exit;
}

}  // namespace armlet::cli
