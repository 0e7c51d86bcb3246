#pragma once
// Programs whose memory is refused at every point.

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <utility>

#include "script_support.hpp"
#include "vm/state/state.hpp"

namespace armlet::lang {

// Runs a program with the first allocation refused, then the second, up to the one before `end`.
// Returns how many runs failed; checks that nothing is left in the heap.
inline std::uint64_t runs_failed_for_memory(const std::string& text, std::uint64_t end) {
  const auto program = compile_script(text).program;
  std::uint64_t failed = 0;
  for (std::uint64_t n = 1; n < end; ++n) {
    VmOptions options;
    options.output = [](std::string_view) {};
    Vm vm(program, std::move(options));
    vm.state().heap.refuse_from(n);
    failed += vm.run().status == Progress::kFailed ? 1 : 0;
    vm.state().clear();
    CHECK(vm.state().heap.used() == 0);
  }
  return failed;
}

}  // namespace armlet::lang
