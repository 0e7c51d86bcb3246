#pragma once

#include <memory>
#include <optional>

#include "armlet/backend/fan_out.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/journal.hpp"

namespace armlet {

// A run that is put aside while another one takes its place.
struct Session::Former {
  std::unique_ptr<Journal> journal;
  std::unique_ptr<Host> host;
  std::unique_ptr<FanOut> fan_out;
  std::unique_ptr<Vm> vm;
  RunResult result;
  bool is_under_way;
  std::optional<LoggedEntry> repeated;
};

}  // namespace armlet
