#pragma once
// Options of the compiler.

#include <atomic>

namespace armlet::lang {

struct LowerOptions {
  const std::atomic<bool>* cancelled = nullptr;  // set by the host: lowering then throws Cancelled
  bool optimise = true;                          // false: plain code with the same results
  // For debuggers: an instruction before each statement, and the registers of variables.
  bool markers = false;
};

}  // namespace armlet::lang
