#include "check/explain/file_names.hpp"

namespace armlet::lang {
namespace {

std::string without_folders(std::string_view path) {
  return std::string(path.substr(path.find_last_of('/') + 1));
}

}  // namespace

bool is_main_file(const Checker& checker) { return checker.shared.files.back() == &checker; }

std::string file_name(const Checker& checker) {
  return without_folders((*checker.into.sources)[checker.file.program.span.source].name());
}

std::string line_phrase(const Checker& checker, Span span) {
  std::string out = "line " + std::to_string(checker.line_of(span));
  if (span.source != checker.file.program.span.source)
    out += " of " + without_folders((*checker.into.sources)[span.source].name());
  return out;
}

}  // namespace armlet::lang
