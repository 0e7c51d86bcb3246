// armlet fmt: formats programs.

#include "armlet/interpreter/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "armlet/core/files.hpp"
#include "console/console.hpp"

namespace armlet::cli {
namespace {

constexpr std::string_view kStandardInput = "-";

// Replaces the file in one step: a reader sees either the old text or the new one. Permissions and
// owner stay. Returns the reason if that was not possible.
std::optional<Error> replace_file(const std::string& path, std::string_view text) {
  Result<NewFile> made = create_file(path);
  if (!made.ok()) return made.error();
  NewFile file = std::move(made).value();
  file.write(text);
  return file.finish();
}

int format_text(const FormatOptions& options, const std::string& name, std::string text) {
  SourceSet sources;
  const Source& source = sources.add(name, std::move(text));
  const Formatted result = format_program(source);
  for (const Diagnostic& problem : result.problems) show(problem, sources, options.json);
  if (!result.text) return kRejected;
  if (result.changed_meaning) {
    progress(
        fmt::format("armlet: a defect of armlet itself: {} was left as it is, because another "
                    "layout would have changed what it says",
                    name));
    return kFailed;
  }
  const bool differs = *result.text != source.text();
  if (options.check) {
    if (differs) print_out(name + "\n");
    return differs ? kUnformatted : kDone;
  }
  if (name == kStandardInput) {
    print_out(*result.text);
    return kDone;
  }
  const std::optional<Error> failed =
      differs ? replace_file(name, *result.text) : std::optional<Error>();
  if (!failed) return kDone;
  progress(fmt::format("armlet: {} cannot be written: {}", name, failed->message));
  return kNoFile;
}

}  // namespace

int format(const FormatOptions& options) {
  int exit = kDone;
  for (const std::string& file : options.files) {
    auto text = file == kStandardInput ? read_file("/dev/stdin", options.json)
                                       : read_file(file, options.json);
    exit = std::max<int>(exit, text ? format_text(options, file, *std::move(text)) : kNoFile);
  }
  return finish_output() ? exit : kFailed;
}

}  // namespace armlet::cli
