#include "driver/trial.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "check/check.hpp"
#include "driver/load_files.hpp"
#include "hir/kept.hpp"

namespace armlet::lang {
namespace {

// Whether the edits, in the order of the text, belong to one file and do not overlap.
bool fit_together(const std::vector<Edit>& edits) {
  for (std::size_t i = 1; i < edits.size(); ++i) {
    const bool overlap = edits[i].span.begin < edits[i - 1].span.end;
    if (overlap || edits[i].span.source != edits[0].span.source) return false;
  }
  return !edits.empty();
}

std::string with_edits(std::string_view text, const std::vector<Edit>& edits) {
  std::string out;
  std::size_t read = 0;
  for (const Edit& edit : edits) {
    out += text.substr(read, edit.span.begin - read);
    out += edit.text;
    read = edit.span.end;
  }
  out += text.substr(read);
  return out;
}

struct Outcome {
  std::shared_ptr<const SourceSet> sources;
  std::vector<Diagnostic> all;
};

// The messages about one file of a program.
Outcome messages_about(const Source& file, const Registry& registry, const Source& main,
                       const CompileOptions& options) {
  DiagnosticSink sink(2 * options.limits.errors);
  CheckedProgram program = new_program(options);
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
  return {program.sources, std::move(out)};
}

}  // namespace

Span Trial::moved(Span place) const {
  Span out = place;
  std::int64_t shift = 0;
  const auto follow = [&](std::uint32_t& to, std::uint32_t from, const Edit& edit,
                          std::int64_t end) {
    if (from >= edit.span.end) to = static_cast<std::uint32_t>(from + shift);
    if (from > edit.span.begin && from < edit.span.end) to = static_cast<std::uint32_t>(end);
  };
  for (const Edit& edit : edits_) {
    shift += static_cast<std::int64_t>(edit.text.size()) - (edit.span.end - edit.span.begin);
    const std::int64_t end = edit.span.end + shift;
    follow(out.begin, place.begin, edit, end);
    follow(out.end, place.end, edit, end);
  }
  return {out.begin, std::max(out.begin, out.end), place.source};
}

std::vector<Span> Trial::places(const Diagnostic& repaired) const {
  std::vector<Span> places = {moved(repaired.mark.span)};
  std::int64_t shift = 0;
  for (const Edit& edit : edits_) {
    const auto begin = static_cast<std::uint32_t>(edit.span.begin + shift);
    places.push_back({begin, begin + static_cast<std::uint32_t>(edit.text.size()), 0});
    shift += static_cast<std::int64_t>(edit.text.size()) - (edit.span.end - edit.span.begin);
  }
  return places;
}

bool Trial::fails_at_its_places(const Diagnostic& repaired) const {
  const std::vector<Span> places = this->places(repaired);
  return std::ranges::any_of(left_, [&](const Diagnostic& other) {
    const bool counts = other.severity == Severity::kError || other.code == repaired.code;
    return counts &&
           std::ranges::any_of(places, [&](Span place) { return touch(place, other.mark.span); });
  });
}

bool Trial::fails_inside(Span part) const {
  const Span now = moved(part);
  return std::ranges::any_of(left_, [&](const Diagnostic& other) {
    return other.severity == Severity::kError && touch(now, other.mark.span);
  });
}

bool Trial::still_says(const Diagnostic& message) const {
  const Span place = moved(message.mark.span);
  return std::ranges::any_of(left_, [&](const Diagnostic& other) {
    return other.code == message.code && other.mark.span.begin == place.begin;
  });
}

Trials::Trials(const Registry& registry, const SourceSet& sources, const CompileOptions& options)
    : registry_(registry), sources_(sources), options_(options) {
  for (std::uint32_t i = sources.first(); i < sources.size(); ++i) all_ += sources[i].text().size();
}

Trials Trials::behind(const Trial& first) const {
  Trials out(registry_, first.sources(), options_);
  out.read_ = read_;
  out.behind_another_ = true;
  return out;
}

std::optional<Trial> Trials::with(std::vector<Edit> edits) {
  std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
  if (exhausted() || !fit_together(edits)) return std::nullopt;
  // The text of an earlier entry has run already.
  if (edits[0].span.source < sources_.first()) return std::nullopt;
  *read_ += all_;
  const Source& source = sources_[edits[0].span.source];
  const Source file(source.name(), with_edits(source.text(), edits), source.id());
  Outcome left = messages_about(file, registry_, sources_[sources_.first()], options_);
  return Trial(std::move(edits), std::move(left.sources), std::move(left.all));
}

}  // namespace armlet::lang
