// A host that is compiled without exceptions: whatever may be wrong comes as a result.
#include <armlet/interpreter/host.hpp>
#include <cstdio>

namespace {

double twice(double x) { return 2.0 * x; }

int failed(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  return 1;
}

}  // namespace

int main() {
  armlet::Engine engine;
  engine.define(armlet::def("twice(x: double) -> double", &twice, "Two times x.", "twice(1.5)"));
  const auto compiled = engine.compile(
      "var speed = 1m/s\n"
      "fn on_tick(x: double) -> double { return twice(x) + 1 }\n"
      "fn broken() -> int { let xs = [1]\n return xs[3] }",
      "host.rbt");
  if (!compiled.program) return failed(compiled.text());
  armlet::Vm vm(compiled.program);
  if (vm.run().error) return failed("the run");
  const auto on_tick = vm.try_function<double(double)>("on_tick");
  if (!on_tick) return failed(on_tick.error().message);
  const armlet::Answer<double> answer = (*on_tick)(20.5);
  if (!answer || *answer != 42.0) return failed(vm.error_text());
  if (vm.try_function<double(std::string)>("on_tick")) return failed("a text is no double");
  const auto refused = vm.try_set("speed", 3);
  if (!refused) return failed("a number is no speed");
  const auto broken = vm.try_function<std::int64_t()>("broken");
  if (!broken || (*broken)()) return failed("there is no fourth element");
  std::printf("%g\n%s\n%s\n", *answer, refused->message.c_str(), vm.error()->code.c_str());
}
