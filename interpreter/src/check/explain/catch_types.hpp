#pragma once
// Explains `catch` with a type, as in other languages.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Reports W0756 for catch (IOException e). The fix catches only errors of that kind if there is
// one, and removes the type otherwise.
void advise_catch_of_a_type(Checker& checker, const ast::CatchClause& clause);

}  // namespace armlet::lang
