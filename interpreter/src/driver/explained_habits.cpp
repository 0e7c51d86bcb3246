#include "driver/explained_habits.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "habits/habits.hpp"

namespace armlet::lang {
namespace {

// The explanations for the texts of a program. Each text is searched at the first message about it.
class Explanations {
 public:
  explicit Explanations(const SourceSet& sources) : sources_(sources) {}

  std::vector<Explanation> of(const Diagnostic& message) {
    const Source& source = sources_[message.mark.span.source];
    std::vector<Explanation> out =
        blocks(source).around(source.position(message.mark.span.begin).line);
    std::ranges::move(explain_line(source, message.mark.span), std::back_inserter(out));
    return out;
  }

 private:
  const ForeignBlocks& blocks(const Source& source) {
    return blocks_.try_emplace(source.id(), source).first->second;
  }

  const SourceSet& sources_;
  std::map<std::uint32_t, ForeignBlocks> blocks_;
};

// Whether `message` is on a line between the first and the last edit of a fix.
bool is_inside(const Diagnostic& message, const Fix& fix, const SourceSet& sources) {
  const Source& source = sources[message.mark.span.source];
  const auto [first, last] =
      std::ranges::minmax_element(fix.edits, {}, [](const Edit& edit) { return edit.span.begin; });
  const int line = source.position(message.mark.span.begin).line;
  return message.mark.span.source == first->span.source &&
         line >= source.position(first->span.begin).line &&
         line <= source.position(last->span.end).line;
}

// Whether the fix of a message leaves no error on its line.
bool repairs_its_line(const Diagnostic& message, const SourceSet& sources, Trials& trials) {
  if (!message.fix || message.fix->edits.empty()) return false;
  const Source& source = sources[message.mark.span.source];
  const int line = source.position(message.mark.span.begin).line;
  const std::uint32_t begin = source.line_start(line);
  const auto end = static_cast<std::uint32_t>(begin + source.line(line).size());
  const std::optional<Trial> trial = trials.with(message.fix->edits);
  return trial && !trial->fails_inside({begin, end, source.id()});
}

// Whether the only errors at the edits of a fix are undeclared names that were in the old line
// already.
bool lacks_only_names(const Trial& trial, const Diagnostic& explanation, const SourceSet& sources) {
  const std::vector<Span> places = trial.places(explanation);
  const std::string_view written = sources.slice(explanation.mark.span);
  bool lacks = false;
  for (const Diagnostic& left : trial.left()) {
    if (left.severity != Severity::kError) continue;
    const auto touches = [&](Span place) { return touch(place, left.mark.span); };
    if (std::ranges::none_of(places, touches)) continue;
    const std::string_view name = trial.sources().slice(left.mark.span);
    if (left.code != "E0201" || left.mark.span.source != 0 ||
        written.find(name) == std::string_view::npos)
      return false;
    lacks = true;
  }
  return lacks;
}

// Replaces message `at` by the explanation, and removes later messages with the same cause; returns
// false if the explanation is not the cause.
bool explain(std::vector<Diagnostic>& messages, std::size_t at, Diagnostic explanation,
             const SourceSet& sources, Trials& trials) {
  if (!explanation.fix) {
    messages[at] = std::move(explanation);
    return true;
  }
  const std::optional<Trial> trial = trials.with(explanation.fix->edits);
  if (!trial || trial->still_says(messages[at])) return false;
  if (lacks_only_names(*trial, explanation, sources)) {
    explanation.fix->edits.clear();
    messages[at] = std::move(explanation);
    return true;
  }
  if (fails_as_shown(*trial, explanation, trials)) return false;
  const auto behind = messages.begin() + static_cast<std::ptrdiff_t>(at) + 1;
  const auto gone = std::remove_if(behind, messages.end(), [&](const Diagnostic& other) {
    return is_inside(other, *explanation.fix, sources) && !trial->still_says(other);
  });
  messages.erase(gone, messages.end());
  messages[at] = std::move(explanation);
  return true;
}

}  // namespace

// Messages are considered in the form in which they are shown: an explanation may have a larger
// mark than the message that it replaces.
bool fails_as_shown(const Trial& trial, const Diagnostic& repaired, const Trials& trials) {
  if (trial.fails_at_its_places(repaired)) return true;
  if (trials.is_behind_another()) return false;
  const std::vector<Span> places = trial.places(repaired);
  const auto is_there = [&](const Diagnostic& message) {
    return std::ranges::any_of(places, [&](Span place) { return touch(place, message.mark.span); });
  };
  Explanations explanations(trial.sources());
  return std::ranges::any_of(trial.left(), [&](const Diagnostic& message) {
    if (message.severity != Severity::kError) return false;
    const auto is_candidate = [&](const Explanation& one) { return is_there(one.message); };
    if (std::ranges::none_of(explanations.of(message), is_candidate)) return false;
    std::vector<Diagnostic> shown = {message};
    Trials next = trials.behind(trial);
    explain_habits(shown, trial.sources(), next);
    return is_there(shown[0]);
  });
}

void explain_habits(std::vector<Diagnostic>& diagnostics, const SourceSet& sources,
                    Trials& trials) {
  Explanations explanations(sources);
  for (std::size_t i = 0; i < diagnostics.size(); ++i) {
    if (diagnostics[i].severity != Severity::kError || trials.exhausted()) continue;
    std::vector<Explanation> given = explanations.of(diagnostics[i]);
    const std::optional<Fix>& fix = diagnostics[i].fix;
    const bool is_sure = fix && fix->confidence == Confidence::kSure;
    // A fix for the whole line is not replaced by a fix for a part of it, nor a certain fix by an
    // explanation without one, nor a fix with a name of the program or the library by another one.
    // A name of another language is not treated as misspelt.
    const bool is_unknown = diagnostics[i].code == "E0201";
    const bool is_named = is_sure && is_unknown;
    const auto is_less = [&](const Explanation& one) {
      if (is_unknown && !is_sure && one.names_it) return false;
      return one.of_value || is_named || (is_sure && !one.message.fix);
    };
    if (std::ranges::any_of(given, is_less) && repairs_its_line(diagnostics[i], sources, trials))
      std::erase_if(given, is_less);
    for (Explanation& one : given) {
      if (explain(diagnostics, i, std::move(one.message), sources, trials)) break;
    }
  }
}

}  // namespace armlet::lang
