#pragma once
// Files and lines in messages.

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] bool is_main_file(const Checker& checker);
// The name of the file without its folders.
[[nodiscard]] std::string file_name(const Checker& checker);
// "line 7", or "line 7 of grip.rbt" for a line of another file.
[[nodiscard]] std::string line_phrase(const Checker& checker, Span span);

}  // namespace armlet::lang
