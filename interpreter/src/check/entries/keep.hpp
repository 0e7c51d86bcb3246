#pragma once
// The end of the check of an entry: stores the names that later entries can use.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Numbers the functions and variables of an entry, gives functions that replace others the numbers
// of these, and fills into.entry.kept. Reports advice where other code still uses an older
// declaration.
void keep_names(Checker& main);

}  // namespace armlet::lang
