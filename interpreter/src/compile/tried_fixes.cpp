#include "compile/tried_fixes.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "check/check.hpp"
#include "compile/load_files.hpp"

namespace armlet::lang {
namespace {

constexpr std::size_t kMostBytes = 256U << 10U;

// A text after some edits, and where its parts are now.
struct Edited {
  std::string text;
  std::vector<Span> places;  // of the replacements, and of the mark of the message last
};

// The edits in the order of the text; empty if they overlap or belong to several files.
std::vector<Edit> in_order(std::vector<Edit> edits) {
  std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
  for (std::size_t i = 1; i < edits.size(); ++i) {
    const bool overlap = edits[i].span.begin < edits[i - 1].span.end;
    if (overlap || edits[i].span.source != edits[0].span.source) return {};
  }
  return edits;
}

Edited with_edits(std::string_view text, const std::vector<Edit>& edits, Span mark) {
  Edited out;
  // Where a position of the old text is in the new one; inside of what is replaced: at its end.
  std::size_t read = 0;
  Span moved = mark;
  for (const Edit& edit : edits) {
    out.text += text.substr(read, edit.span.begin - read);
    const auto begin = static_cast<std::uint32_t>(out.text.size());
    out.text += edit.text;
    const auto end = static_cast<std::uint32_t>(out.text.size());
    out.places.push_back({begin, end, 0});
    read = edit.span.end;
    const auto shift = static_cast<std::int64_t>(end) - edit.span.end;
    const auto follow = [&](std::uint32_t& to, std::uint32_t from) {
      if (from >= edit.span.end) to = static_cast<std::uint32_t>(from + shift);
      if (from > edit.span.begin && from < edit.span.end) to = end;
    };
    follow(moved.begin, mark.begin);
    follow(moved.end, mark.end);
  }
  out.text += text.substr(read);
  const auto size = static_cast<std::uint32_t>(out.text.size());
  moved = {std::min(moved.begin, size), std::min(std::max(moved.begin, moved.end), size), 0};
  out.places.push_back(moved);
  return out;
}

bool touch(Span a, Span b) { return a.begin <= b.end && b.begin <= a.end; }

// What is wrong in one file of a program.
std::vector<Diagnostic> messages_about(const Source& file, const Registry& registry,
                                       const Source& main, const CompileOptions& options) {
  DiagnosticSink sink(2 * options.limits.errors);
  CompiledProgram program;
  program.sources = std::make_shared<SourceSet>();
  SourceSet& sources = *program.sources;
  const Source& first = main.id() == file.id() ? file : main;
  sources.add(first.name(), std::string(first.text()));
  CompileOptions again = options;
  if (options.load) {
    again.load = [&](const std::string& path, const std::string& from) {
      ImportedText found = options.load(path, from);
      if (found.text && found.name == file.name()) found.text = file.text();
      return found;
    };
  }
  Arena tree;
  const std::vector<FileTree> files = load_files(sources, tree, again, sink);
  static_cast<void>(check_program(files, program, registry, again, sink));
  std::vector<Diagnostic> out = sink.take_sorted();
  std::erase_if(out, [&](const Diagnostic& diagnostic) {
    return sources[diagnostic.mark.span.source].name() != file.name();
  });
  return out;
}

}  // namespace

void drop_useless_fixes(std::vector<Diagnostic>& diagnostics, const Registry& registry,
                        const SourceSet& sources, const CompileOptions& options) {
  std::size_t all = 0;
  for (std::uint32_t i = 0; i < sources.size(); ++i) all += sources[i].text().size();
  std::size_t read = 0;
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.fix || diagnostic.fix->edits.empty()) continue;
    read += all;
    if (read > kMostBytes) {
      diagnostic.fix->confidence = Confidence::kMaybe;
      continue;
    }
    const std::vector<Edit> edits = in_order(diagnostic.fix->edits);
    const Source& source = sources[diagnostic.mark.span.source];
    if (edits.empty() || edits[0].span.source != source.id()) continue;
    Edited edited = with_edits(source.text(), edits, diagnostic.mark.span);
    const Source file(source.name(), std::move(edited.text), source.id());
    const std::vector<Diagnostic> left = messages_about(file, registry, sources[0], options);
    const bool fails = std::ranges::any_of(left, [&](const Diagnostic& other) {
      const bool counts = other.severity == Severity::kError || other.code == diagnostic.code;
      return counts && std::ranges::any_of(edited.places, [&](Span place) {
               return touch(place, other.mark.span);
             });
    });
    if (fails) diagnostic.fix.reset();
  }
}

}  // namespace armlet::lang
