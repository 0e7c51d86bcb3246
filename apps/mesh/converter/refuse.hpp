#pragma once

#include <string>

#include "armlet/core/error.hpp"

namespace armlet::mesh {

// A file is not converted because of WHY.
[[noreturn]] inline void refuse(const std::string& why) { throw ArgumentError(why); }

}  // namespace armlet::mesh
