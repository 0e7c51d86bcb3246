#include "armlet/backend/trace_format.hpp"

#include "armlet/backend/csv_backend.hpp"
#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/backend/npy_backend.hpp"

namespace armlet {
namespace {

constexpr TraceFormat kFormats[] = {
    {.ending = ".csv", .holds = "every sample, as a table", .make = make_csv_backend},
    {.ending = ".jsonl",
     .holds = "samples and events, as lines of JSON",
     .make = make_jsonl_backend},
    {.ending = ".npy",
     .holds = "the samples of the robots, as an array of NumPy",
     .make = make_npy_backend},
};

}  // namespace

std::span<const TraceFormat> trace_formats() { return kFormats; }

const TraceFormat* trace_format_of(std::string_view path) {
  for (const TraceFormat& format : kFormats) {
    if (path.ends_with(format.ending)) return &format;
  }
  return nullptr;
}

std::string trace_endings() {
  std::string endings;
  for (const TraceFormat& format : kFormats) {
    const bool last = &format == std::end(kFormats) - 1;
    if (!endings.empty()) endings += last ? " or " : ", ";
    endings += format.ending;
  }
  return endings;
}

}  // namespace armlet
