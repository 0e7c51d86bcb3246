#pragma once
// Reports structs that contain themselves, directly or through others: their values would be
// infinite.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void refuse_endless(Checker& checker);

}  // namespace armlet::lang
