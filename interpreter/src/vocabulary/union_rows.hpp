#pragma once
// Rows with union types: "(m: motor, to: point? | double[])" stands for two functions, one whose
// `to` is a point or absent, and one whose `to` is a list.

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
