#pragma once
// Functions of the library as a reader writes them.

#include <string>
#include <string_view>

#include "vocabulary/registry.hpp"

namespace armlet::lang {

// How a reader would write what the table calls `name`: "point.x" is a field, "motor{}" a block
// declaration. Empty for what no program writes.
[[nodiscard]] std::string written_call(const Registry& registry, const NativeFunction& function);

// The word of a block whose setting this is: "with" of "with.speed"; empty for other names.
[[nodiscard]] std::string_view block_of(std::string_view name);
// The type that "image[]", "image.grey[]" and "image[:]" are about.
[[nodiscard]] std::string_view indexed(std::string_view name);

}  // namespace armlet::lang
