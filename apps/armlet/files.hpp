#pragma once
// Text from files.

#include <optional>
#include <string>

namespace armlet::cli {

// The text of a file, cut behind the longest program; nothing, and the reason, if it cannot be
// read.
std::optional<std::string> read_text(const std::string& path, std::string& reason);

}  // namespace armlet::cli
