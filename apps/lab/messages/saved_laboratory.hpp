#pragma once
// A laboratory that was exported: `laboratory` of the message "exported" (docs/lab-protocol.md), as
// far as whoever opens it needs it. The runs in it are taken again by the worker's script.

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/stdlib/session_log.hpp"

namespace armlet::lab {

struct SavedLaboratory {
  std::string robot;
  std::optional<WorldText> world;
  std::string file;
  std::string text;
  bool is_demo = false;
  std::map<std::string, std::string> files;
};

// returns  an error, a sentence, for everything that is none, or is of another edition.
[[nodiscard]] Result<SavedLaboratory> read_saved(std::string_view json, std::string_view version);

}  // namespace armlet::lab
