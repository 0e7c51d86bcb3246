#pragma once
// Structs that hold themselves, directly or through others: a value of one would never end.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void refuse_endless(Checker& checker);

}  // namespace armlet::lang
