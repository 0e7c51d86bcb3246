#pragma once
// The calls of library functions as programs write them.

#include <string>
#include <string_view>

#include "vocabulary/registry.hpp"

namespace armlet::lang {

// The text of a call of the function `name`: "point.x" is a field, "motor{}" a block declaration.
// Empty for functions that no program writes.
[[nodiscard]] std::string written_call(const Registry& registry, const NativeFunction& function);

// The block that a setting belongs to: "with" for "with.speed"; empty for other names.
[[nodiscard]] std::string_view block_of(std::string_view name);
// The type in "image[]", "image.grey[]" and "image[:]".
[[nodiscard]] std::string_view indexed(std::string_view name);

}  // namespace armlet::lang
