#pragma once
// How a program is lowered.

#include <atomic>

namespace armlet::lang {

struct LowerOptions {
  const std::atomic<bool>* cancelled = nullptr;  // by the host: lowering throws Cancelled soon
  bool optimise = true;                          // off: plain code with the same results
  bool markers = false;  // an instruction before each statement, and where its variables are
};

}  // namespace armlet::lang
