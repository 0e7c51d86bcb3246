// A control loop of 1 kHz of the host: in each tick it calls the controller of the program, lets
// the program's own tasks run up to the same time, and passes values. With --paced it follows the
// wall clock; the results do not depend on that.
#include <armlet/interpreter/host.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <string_view>
#include <thread>

namespace {

constexpr std::string_view kProgram = R"(
  var target = 20mm
  var gain = 8 / 1s
  var worst = 0mm

  fn on_tick(x: length) -> speed {
    let off = target - x
    if (off > worst) { worst = off }
    return gain * off
  }

  every (250ms) { print("at most", worst, "below the target") }
  wait(1s)
)";

}  // namespace

int main(int count, char** arguments) {
  const bool is_paced = count > 1 && std::string_view(arguments[1]) == "--paced";
  const armlet::Engine engine;
  const armlet::Compilation compiled = engine.compile(std::string(kProgram), "controller.rbt");
  std::cout << compiled.text();
  if (!compiled.program) return 1;
  armlet::Vm vm(compiled.program, {.output = [](std::string_view text) { std::cout << text; }});

  // Runs to the first wait, so that the variables of the program have values.
  vm.run({.until_ns = 0});
  const auto on_tick = vm.function<double(double)>("on_tick");

  constexpr std::int64_t kTick_ns = 1'000'000;
  double x = 0.0;  // m
  auto next = std::chrono::steady_clock::now();
  for (int tick = 1; tick <= 1000; ++tick) {
    const armlet::Answer<double> speed = on_tick(x);
    if (!speed) {
      std::cerr << vm.error_text();
      return 1;
    }
    x += *speed * 1e-3;
    if (tick == 500) vm.set("target", 25, "mm");
    if (vm.run({.until_ns = tick * kTick_ns}) == armlet::Progress::kFailed) return 1;
    if (is_paced) std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
  }
  std::printf("x is %.1f mm, at most %.1f mm below\n", x * 1e3, vm.global("worst").in("mm"));
}

// Prints:
// at most 0 mm below the target
// at most 20 mm below the target
// at most 20 mm below the target
// at most 20 mm below the target
// x is 24.9 mm, at most 20.0 mm below
