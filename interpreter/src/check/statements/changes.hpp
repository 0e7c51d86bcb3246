#pragma once
// What functions change besides their own variables: what conditions may not do.

#include <optional>
#include <string>

#include "check/checker.hpp"

namespace armlet::lang {

// One change: where it is written, and what is changed: "`n`", or empty for a call of the library.
struct Change {
  Span span;
  std::string what{};
};

// Which changes are looked for: what a row of a laboratory assigns is undone after it is read, what
// the library does is not.
enum class Changes { kAll, kOfLibrary };

// The first change that `function` makes, or a function that it mentions: a variable of the program
// is assigned, a list or map of it is changed, or a call of the library acts.
[[nodiscard]] std::optional<Change> first_change(Checker& checker, const hir::Function* function,
                                                 Changes of = Changes::kAll);

// Refuses conditions of `until`, `wait until` and `when` that change something (E0533); after
// everything is checked.
void check_condition_changes(Checker& checker);

}  // namespace armlet::lang
