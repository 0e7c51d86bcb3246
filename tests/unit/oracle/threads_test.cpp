// Several threads share engines and programs; each virtual machine belongs to one thread.

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "armlet/stdlib/install.hpp"
#include "comparison.hpp"
#include "random/program.hpp"

using namespace armlet;
using namespace armlet::oracle;

namespace {

constexpr int kThreads = 8;

Engine full_engine() {
  Engine engine;
  install(engine);
  return engine;
}

// What some programs write, compiled and run by whoever calls this.
std::vector<std::string> outputs(const Engine& engine) {
  std::vector<std::string> out;
  for (std::uint64_t number = 1; number <= 25; ++number) {
    const Compilation compilation = engine.compile(RandomProgram(number).text(), "program.rbt");
    out.push_back(compilation.program == nullptr ? "not compiled"
                                                 : run_machine(compilation.program));
  }
  return out;
}

}  // namespace

TEST_CASE("8 threads compile and run programs on one engine as one thread does") {
  const Engine engine = full_engine();
  std::vector<std::vector<std::string>> results(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::vector<std::string>& result : results)
      threads.emplace_back([&] { result = outputs(engine); });
  }
  const std::vector<std::string> alone = outputs(engine);
  for (const std::vector<std::string>& result : results) CHECK(result == alone);
}

TEST_CASE("8 machines run one program at the same time") {
  const Engine engine = full_engine();
  for (std::uint64_t number = 1; number <= 10; ++number) {
    const auto program = engine.compile(RandomProgram(number).text(), "program.rbt").program;
    REQUIRE(program != nullptr);
    std::vector<std::string> results(kThreads);
    {
      std::vector<std::jthread> threads;
      for (std::string& result : results)
        threads.emplace_back([&] { result = run_machine(program); });
    }
    const std::string alone = run_machine(program);
    for (const std::string& result : results) CHECK(result == alone);
  }
}
