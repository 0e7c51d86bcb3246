// A program is replaced while the host runs: variables with the same name and type keep their
// values, and the others are reported to the host.
#include <armlet/interpreter/host.hpp>
#include <iostream>
#include <memory>

namespace {

std::unique_ptr<armlet::Vm> load(const armlet::Engine& engine, const char* text) {
  const armlet::Compilation compiled = engine.compile(text, "counter.rbt");
  std::cout << compiled.text();
  if (!compiled.program) return nullptr;
  auto vm = std::make_unique<armlet::Vm>(compiled.program, armlet::VmOptions{});
  if (vm->run().status == armlet::Progress::kDone) return vm;
  std::cout << vm->error_text();
  return nullptr;
}

// The new version, or the old one if the new one has mistakes.
std::unique_ptr<armlet::Vm> reload(const armlet::Engine& engine, const char* text,
                                   std::unique_ptr<armlet::Vm> old) {
  std::unique_ptr<armlet::Vm> fresh = load(engine, text);
  if (fresh == nullptr) return old;
  const armlet::CarriedGlobals carried = armlet::carry_globals(*old, *fresh);
  for (const auto& name : carried.kept) std::cout << name << " is kept\n";
  for (const auto& [name, why] : carried.lost) std::cout << name << " is lost: " << why << '\n';
  for (const auto& name : carried.fresh) std::cout << name << " is new\n";
  return fresh;
}

void count(armlet::Vm& vm) {
  if (const auto text = vm.function<std::string()>("step")()) std::cout << *text << '\n';
}

}  // namespace

int main() {
  const armlet::Engine engine;
  auto vm = load(engine, R"(
    var count = 0
    var pause = 100ms
    var seen = ["start"]
    fn step() -> string { count += 1
      seen.push(f"step {count}")
      return f"{count} of {seen.length}, pause {pause}" }
  )");
  if (vm == nullptr) return 1;
  count(*vm);
  count(*vm);
  vm = reload(engine, R"(
    var count = 0
    var pause = 0.1
    var seen = ["start"]
    var by = 10
    fn step() -> string { count += by
      return f"{count} of {seen.length}, pause {pause}" }
  )",
              std::move(vm));
  count(*vm);
  vm = reload(engine, "fn step() -> string { return coutn }", std::move(vm));  // does not compile
  count(*vm);
}

// Prints:
// 1 of 2, pause 0.1 s
// 2 of 3, pause 0.1 s
// count is kept
// seen is kept
// pause is lost: it was a time, and is a double
// by is new
// 12 of 3, pause 0.1
// error E0201: there is nothing called `coutn`
//  --> counter.rbt:1:30
//   |
// 1 | fn step() -> string { return coutn }
//   |                              ^^^^^
// 22 of 3, pause 0.1
