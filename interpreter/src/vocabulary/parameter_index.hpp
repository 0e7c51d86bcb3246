#pragma once
// Parameters of a signature by name, without reading its types.

#include <string_view>

namespace armlet::lang {

// The index of the parameter `name` in "(m: motor, to: point) -> Run", from 0; -1: it has none.
[[nodiscard]] int parameter_index(std::string_view signature, std::string_view name);

}  // namespace armlet::lang
