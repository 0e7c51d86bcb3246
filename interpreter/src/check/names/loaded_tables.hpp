#pragma once
// Tables that are read from files: which columns they have is found out when the program is
// checked.

#include <string>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The type of what a function gives whose result is a `table` and which has a parameter `file`: the
// columns are those that its text parameter `columns` says, or else those of the file, which is
// read as if the program imported it. Both have to be known from the text.
//
// columns  what `columns` is if it was left out (table_text.hpp).
// returns  null after a message.
[[nodiscard]] const Type* loaded_table(Checker& checker, const Signature& signature, const Fit& fit,
                                       const std::vector<Argument>& arguments, Span span,
                                       std::string& columns);

}  // namespace armlet::lang
