#pragma once
// Converts messages to text for people (language reference, section 20.1) and to JSON for editors.

#include <optional>
#include <string>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

struct RenderOptions {
  bool color = false;  // ANSI colours, for terminals
};

// The span of a mark in no text, for messages about a file as a whole.
inline constexpr Span kNoText{0, 0, 0xFFFFFFFF};

// The headline, the marked lines and the notes; ends with a line break.
//
// A related mark with an empty span and no label shows its line without marking anything. A mark
// over several lines is drawn on its first line. The output has no control characters.
[[nodiscard]] std::string render_text(const Diagnostic& diagnostic, const SourceSet& sources,
                                      RenderOptions options = {});

// One JSON object on one line, without a line break. `text` is the first line of the marked text.
[[nodiscard]] std::string render_json(const Diagnostic& diagnostic, const SourceSet& sources);

// Whether the circumstances contain information to show; not so before the first action of a run.
[[nodiscard]] bool tells_something(const std::optional<When>& when);

// The circumstances as text: "at t = 4.00 s, motor left, nothing has moved"
[[nodiscard]] std::string when_text(const When& when);

}  // namespace armlet
