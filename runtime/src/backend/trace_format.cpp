#include "armlet/backend/trace_format.hpp"

#include "armlet/backend/csv_backend.hpp"
#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/backend/npy_backend.hpp"

namespace armlet {
namespace {

template <class Format>
std::unique_ptr<Backend> make(std::ostream& out) {
  return std::make_unique<Format>(out);
}

constexpr TraceFormat kFormats[] = {
    {.ending = ".csv", .holds = "every sample, as a table", .make = make<CsvBackend>},
    {.ending = ".jsonl",
     .holds = "samples and events, as lines of JSON",
     .make = make<JsonlBackend>},
    {.ending = ".npy",
     .holds = "the samples of the robots, as an array of NumPy",
     .make = make<NpyBackend>},
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
