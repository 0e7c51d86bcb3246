#pragma once
// Habits of other languages: one row each. How shapes are written is said in pattern.hpp, how texts
// with places in meant.hpp.

#include <span>
#include <string_view>

namespace armlet::lang {

// There is no such thing here: the message says why, and no fix is given.
inline constexpr std::string_view kNoSuchThing = "-";
// What is written here begins with it: it is shown, and no edit makes it, because it does not do
// the same, or only with values that the line does not hold.
inline constexpr char kOnlyShown = '?';

// Reasons that several tables give.
inline constexpr std::string_view kZones =
    "a move stops at its goal; in a path, blend: 10mm rounds corners";
inline constexpr std::string_view kNamedSignals = "signals have names";
inline constexpr std::string_view kFromZero = "indexes stand in square brackets and count from 0";

struct Habit {
  std::string_view shape;
  std::string_view here;  // empty: not needed here; kNoSuchThing
  std::string_view why;   // one sentence, may be empty
};

// Whole statements, and values anywhere in a line: of languages, and of toolboxes for robots.
[[nodiscard]] std::span<const Habit> statement_habits();
[[nodiscard]] std::span<const Habit> value_habits();
[[nodiscard]] std::span<const Habit> toolbox_habits();

// A block that begins with a line of its own.
struct BlockHabit {
  std::string_view shape;  // of its first line
  std::string_view here;   // empty: the block is no block here; its lines stay
  // The word of its last line, "end|ENDWHILE" for one of two; ":": it ends with its indentation, or
  // with `end`.
  std::string_view end;
  bool gives_first = false;  // function y = f(x): gives the variable that is its first part
};

[[nodiscard]] std::span<const BlockHabit> block_habits();

// Lines between: else, elif n > 2:, CASE 1. And what the last line means.
[[nodiscard]] std::span<const Habit> middle_habits();
[[nodiscard]] std::span<const Habit> end_habits();

}  // namespace armlet::lang
