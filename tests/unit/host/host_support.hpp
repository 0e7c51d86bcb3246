#pragma once
// A program of a host, compiled and run to its end.

#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "armlet/interpreter/host.hpp"

namespace armlet {

inline std::shared_ptr<const Program> compiled(const Engine& engine, const std::string& text,
                                               const CompileOptions& options = {}) {
  const Compilation compilation = engine.compile(text, "host.rbt", options);
  REQUIRE_MESSAGE(compilation.program != nullptr, compilation.text());
  return compilation.program;
}

// What the program has printed is `printed`.
struct Hosted {
  explicit Hosted(const std::string& text, VmOptions options = {}, const Engine& engine = Engine())
      : vm(compiled(engine, text), with_output(std::move(options))) {
    const RunResult result = vm.run();
    const std::string why =
        result.error ? render_text(*result.error, vm.program().sources()) : std::string();
    REQUIRE_MESSAGE(result.status == Progress::kDone, why);
  }

  std::string printed;
  Vm vm;

 private:
  VmOptions with_output(VmOptions options) {
    options.output = [this](std::string_view text) { printed += text; };
    return options;
  }
};

}  // namespace armlet
