#pragma once
// What a program prints that is compiled by an engine of the test.

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

inline std::string printed(const Engine& engine, const std::string& text) {
  const Compilation compilation = engine.compile(text, "test.rbt");
  for (const Diagnostic& d : compilation.diagnostics) CAPTURE(d.message);
  REQUIRE(compilation.program != nullptr);
  std::string out;
  VmOptions options;
  options.output = [&](std::string_view part) { out += part; };
  Vm vm(compilation.program, std::move(options));
  (void)vm.run();
  return out;
}

}  // namespace armlet
