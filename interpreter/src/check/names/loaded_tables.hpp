#pragma once
// Tables that a program loads from files: their columns are determined while the program is
// checked.

#include <string>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The type of the result of a function that returns a `table` and has a parameter `file`. The
// columns are those of its text parameter `columns`, or else those of the file, which is read like
// an import. Both arguments have to be known from the text.
//
// columns  the default of `columns` (table_text.hpp).
// returns  null after a message.
[[nodiscard]] const Type* loaded_table(Checker& checker, const Signature& signature, const Fit& fit,
                                       const std::vector<Argument>& arguments, Span span,
                                       std::string& columns);

}  // namespace armlet::lang
