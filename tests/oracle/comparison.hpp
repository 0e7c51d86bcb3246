#pragma once
// Runs a program on the machine, with and without optimisation, and in the oracle, and compares
// what they did.

#include <memory>
#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet::oracle {

// What one evaluation did: all that it wrote, then the error that ended it with its position.
struct Report {
  std::string oracle;
  std::string plain;
  std::string optimised;
  std::string plain_details;  // of the error: why, where it was called from
  std::string optimised_details;
  std::string not_compiled;  // the first mistake; the program did not run

  [[nodiscard]] bool agrees() const {
    return not_compiled.empty() && oracle == plain && oracle == optimised;
  }
  [[nodiscard]] std::string text() const;
};

// Calls may be nested this deep; the oracle uses the stack of the processor.
inline constexpr RunLimits kLimits{.steps = 1'000'000, .call_depth = 60};

// What a program writes, then the error that ends it. more: gets whatever else the machine says
// about that; may be null.
[[nodiscard]] std::string run_machine(const std::shared_ptr<const Program>& program,
                                      const RunLimits& limits = kLimits,
                                      std::string* more = nullptr);

[[nodiscard]] Report compare(const Engine& engine, const std::string& program);

// A shorter program that the two still disagree about: lines and blocks are left out as long as
// they do.
[[nodiscard]] std::string reduce(const Engine& engine, std::string program);

}  // namespace armlet::oracle
