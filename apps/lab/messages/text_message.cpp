#include "text_message.hpp"

#include <algorithm>

#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/render.hpp"

namespace armlet::lab {
namespace {

MarkedPlace place_of_mark(const Mark& mark, const SourceSet& sources) {
  MarkedPlace place{.label = mark.label};
  if (mark.span.source == kNoText.source || mark.span.source >= sources.size()) return place;
  place.file = sources[mark.span.source].name();
  place.span = span_of(sources, mark.span);
  return place;
}

std::optional<TextFix> resolved_fix(const std::optional<Fix>& fix, const SourceSet& sources) {
  if (!fix) return std::nullopt;
  TextFix out{.text = fix->text, .is_sure = fix->confidence == Confidence::kSure};
  for (const Edit& edit : fix->edits) {
    const auto span = span_of(sources, edit.span);
    if (!span) return TextFix{.text = fix->text};
    out.edits.push_back({*span, edit.text});
  }
  return out;
}

}  // namespace

TextMessage resolved(const Diagnostic& diagnostic, const SourceSet& sources) {
  TextMessage out{.is_error = diagnostic.severity == Severity::kError,
                  .code = diagnostic.code,
                  .message = diagnostic.message,
                  .place = place_of_mark(diagnostic.mark, sources),
                  .why = diagnostic.why,
                  .fix = resolved_fix(diagnostic.fix, sources)};
  for (const Mark& mark : diagnostic.related) out.related.push_back(place_of_mark(mark, sources));
  if (diagnostic.when) {
    out.t = to_seconds(diagnostic.when->time_ns);
    if (tells_something(diagnostic.when)) out.when = when_text(*diagnostic.when);
  }
  return out;
}

}  // namespace armlet::lab
