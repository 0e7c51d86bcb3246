#include "armlet/interpreter/watchdog.hpp"

#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

struct Guarded {
  RunStatus status;
  bool barked;
  std::string output;
};

Guarded run_guarded(const std::string& text, std::chrono::nanoseconds time) {
  Guarded guarded;
  VmOptions options;
  options.limits.steps = 1ULL << 60U;
  options.output = [&](std::string_view part) { guarded.output += part; };
  Vm vm(compiled(text), options);
  const Watchdog watchdog(vm, time);
  guarded.status = vm.run().status;
  guarded.barked = watchdog.has_barked();
  return guarded;
}

}  // namespace

TEST_CASE("a program that takes too long is cancelled, and its finally blocks run") {
  const Guarded endless = run_guarded("try { while (true) { } } finally { print(\"home\") }",
                                      std::chrono::milliseconds(20));
  CHECK(endless.status == RunStatus::kCancelled);
  CHECK(endless.barked);
  CHECK(endless.output == "home\n");
}

TEST_CASE("a program that ends in time sees nothing of the limit") {
  const Guarded quick = run_guarded("print(1)", std::chrono::hours(1));
  CHECK(quick.status == RunStatus::kDone);
  CHECK_FALSE(quick.barked);
  CHECK(quick.output == "1\n");
}
