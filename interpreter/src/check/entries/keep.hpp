#pragma once
// The end of the check of an entry: what it leaves for those behind it.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Whether the entry declares a function anew that the entries before it know.
[[nodiscard]] bool replaces_functions(const Checker& main);
// Numbers the functions and variables of an entry, gives functions that replace others the numbers
// of these, and fills into.entry.kept. Advises where something keeps to an older declaration.
void keep_names(Checker& main);

}  // namespace armlet::lang
