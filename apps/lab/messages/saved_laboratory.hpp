#pragma once
// An exported laboratory: `laboratory` of the message "exported" (docs/lab-protocol.md), without
// its runs. The script of the worker replays the runs.

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

// returns  an error, a sentence, if the JSON is no exported laboratory or is from another version.
[[nodiscard]] Result<SavedLaboratory> read_saved(std::string_view json, std::string_view version);

}  // namespace armlet::lab
