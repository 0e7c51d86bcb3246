#pragma once
// Rows with union types: "(r: robot, frame: posC? | object)" stands for two functions, one whose
// frame is a posC or absent, and one whose frame is an object.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

// Whether a type in the signature is a union.
[[nodiscard]] bool has_union(std::string_view signature);
// The signatures that a row stands for: one for each choice of types, in the order of the row, the
// types of the last union vary first. Only the signature itself if it has no union.
[[nodiscard]] std::vector<std::string> signatures_of(std::string_view signature);
// The function for choice `i`, whose signature is `signature`.
[[nodiscard]] NativeFunction choice_of(const NativeFunction& row, std::size_t i,
                                       std::string_view signature);

}  // namespace armlet::lang
