#pragma once
// Finds changes that functions make outside of their own variables, which conditions must not do.

#include <optional>
#include <string>
#include <unordered_map>

#include "check/state/checker.hpp"

namespace armlet::lang {

// One change: its span, and the changed variable, such as "`n`"; empty for a call of the library.
struct Change {
  Span span;
  std::string what{};
};

// The changes to find: all, or only calls of the library. Assignments by a row of a laboratory are
// undone after it is read, but calls of the library are not.
enum class Changes { kAll, kOfLibrary };

// Finds changes in functions and in the functions that these use: assignments to global variables,
// changes of their lists and maps, and calls of the library that act. Each function is searched
// once, however often it is used.
class ChangeFinder {
 public:
  ChangeFinder(Checker& checker, Changes of) : checker_(checker), of_(of) {}

  // A change that `function` makes, directly or through another function; empty if there is none.
  [[nodiscard]] std::optional<Change> find(const hir::Function* function);

 private:
  Checker& checker_;
  Changes of_;
  std::unordered_map<const hir::Function*, std::optional<Change>> known_{};
};

// Reports E0533 for conditions of `until`, `wait until` and `when` that change something; called
// after everything is checked.
void check_condition_changes(Checker& checker);
// Refuses functions handed to the library that would take time (E0520); after everything is checked.
void check_callbacks(Checker& checker);

}  // namespace armlet::lang
