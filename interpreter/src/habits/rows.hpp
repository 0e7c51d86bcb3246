#pragma once
// The tables of habits of other languages, one row each. pattern.hpp describes the shapes,
// meant.hpp the templates.

#include <span>
#include <string_view>

namespace armlet::lang {

// The construct has no counterpart: the message gives the reason and no fix.
inline constexpr std::string_view kNoSuchThing = "-";
// The first character of a replacement that is shown but not applied as an edit, because it does
// not do the same, or does so only for values that the line does not show.
inline constexpr char kOnlyShown = '?';

// Reasons that several rows share.
inline constexpr std::string_view kZones =
    "a move stops at its goal; in a path, blend: 10mm rounds corners";
inline constexpr std::string_view kNamedSignals = "signals have names";
inline constexpr std::string_view kFromZero = "indexes stand in square brackets and count from 0";

struct Habit {
  std::string_view shape;
  std::string_view here;  // empty: not needed in this language; kNoSuchThing
  std::string_view why;   // one sentence, may be empty
};

// Habits of whole statements, and of values anywhere in a line: of languages, and of toolboxes for
// robots.
[[nodiscard]] std::span<const Habit> statement_habits();
[[nodiscard]] std::span<const Habit> value_habits();
[[nodiscard]] std::span<const Habit> toolbox_habits();

// A habit of a block whose first line is a line of its own.
struct BlockHabit {
  std::string_view shape;  // of its first line
  std::string_view here;   // empty: not a block in this language; its lines stay
  // The word of its last line, "end|ENDWHILE" for two possible ones; ":" if the block ends by
  // indentation, or with `end`.
  std::string_view end;
  bool gives_first = false;  // function y = f(x): returns the variable that is its first part
};

[[nodiscard]] std::span<const BlockHabit> block_habits();

// Lines in the middle of a block: else, elif n > 2:, CASE 1. And the lines that end it.
[[nodiscard]] std::span<const Habit> middle_habits();
[[nodiscard]] std::span<const Habit> end_habits();

}  // namespace armlet::lang
