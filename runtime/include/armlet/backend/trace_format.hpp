// File formats of traces.
#pragma once

#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A format is one row of runtime/src/backend/trace_format.cpp; the command line, its messages, its
// help and the manual page read these rows.
struct TraceFormat {
  std::string_view ending;  // of the name of the file: ".csv"
  std::string_view holds;   // contents: "every sample, as a table"
  // out  not owned; lives at least as long as the backend.
  std::unique_ptr<Backend> (*make)(std::ostream& out) = nullptr;
};

[[nodiscard]] std::span<const TraceFormat> trace_formats();

// The format of a file by the ending of its name; null if there is none.
[[nodiscard]] const TraceFormat* trace_format_of(std::string_view path);

// The endings as words of a sentence: ".csv or .jsonl".
[[nodiscard]] std::string trace_endings();

}  // namespace armlet
