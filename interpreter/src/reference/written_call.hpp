#pragma once
// Functions of the library as a reader writes them.

#include <string>

#include "registry.hpp"

namespace armlet::lang {

// How a reader would write what the table calls `name`: "point.x" is a field, "motor{}" a block
// declaration. Empty for what no program writes.
[[nodiscard]] std::string written_call(const Registry& registry, const NativeFunction& function);

}  // namespace armlet::lang
