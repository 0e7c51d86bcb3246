#pragma once
// Facts that need the whole program: the global variables that tests need, variables that may be
// read too early, and conditions that would wait.

#include "check/state/checker.hpp"

namespace armlet::lang {

void finish_usage(Checker& checker);

}  // namespace armlet::lang
