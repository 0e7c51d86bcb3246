#pragma once
// What functions change besides their own variables: what conditions may not do.

#include <optional>
#include <string>
#include <unordered_map>

#include "check/state/checker.hpp"

namespace armlet::lang {

// One change: where it is written, and what is changed: "`n`", or empty for a call of the library.
struct Change {
  Span span;
  std::string what{};
};

// Which changes are looked for: what a row of a laboratory assigns is undone after it is read, what
// the library does is not.
enum class Changes { kAll, kOfLibrary };

// Looks for changes in functions and in those that they mention: a variable of the program is
// assigned, a list or map of it is changed, or a call of the library acts. Each function is looked
// through once, however many questions lead to it.
class ChangeFinder {
 public:
  ChangeFinder(Checker& checker, Changes of) : checker_(checker), of_(of) {}

  // A change that `function` makes, or one that it mentions; nothing: none does.
  [[nodiscard]] std::optional<Change> find(const hir::Function* function);

 private:
  Checker& checker_;
  Changes of_;
  std::unordered_map<const hir::Function*, std::optional<Change>> known_{};
};

// Refuses conditions of `until`, `wait until` and `when` that change something (E0533); after
// everything is checked.
void check_condition_changes(Checker& checker);

}  // namespace armlet::lang
