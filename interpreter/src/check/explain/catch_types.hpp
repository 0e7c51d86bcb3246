#pragma once
// `catch` with a type, as other languages write it.

#include "check/state/checker.hpp"

namespace armlet::lang {

// W0756: catch (IOException e). The fix keeps to the errors of that kind if there is one, and
// leaves the type out otherwise.
void advise_catch_of_a_type(Checker& checker, const ast::CatchClause& clause);

}  // namespace armlet::lang
