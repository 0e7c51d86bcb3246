#pragma once

#include <string>

#include "armlet/core/error.hpp"

namespace armlet::mesh {

// Refuses to convert a file, with the reason `why`.
[[noreturn]] inline void refuse(const std::string& why) { throw ArgumentError(why); }

}  // namespace armlet::mesh
