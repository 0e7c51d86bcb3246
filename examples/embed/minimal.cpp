// The smallest host: an engine, a program, a run.
#include <armlet/interpreter/host.hpp>
#include <iostream>

int main() {
  const armlet::Engine engine;
  const armlet::Compilation compiled = engine.compile(R"(
    fn greeting(name: string) -> string { return f"Hello, {name}." }
    print(greeting("host"))
  )",
                                                      "hello.rbt");
  if (!compiled.program) {
    std::cerr << compiled.text();
    return 1;
  }
  armlet::Vm vm(compiled.program, {.output = [](std::string_view text) { std::cout << text; }});
  if (vm.run().status != armlet::Progress::kDone) {
    std::cerr << vm.error_text();
    return 1;
  }
  const auto greeting = vm.function<std::string(std::string)>("greeting");
  if (const auto text = greeting("program")) std::cout << *text << '\n';
}

// Prints:
// Hello, host.
// Hello, program.
