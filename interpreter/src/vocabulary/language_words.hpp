#pragma once
// Descriptions of the calls that the checker treats as part of the language
// (check/calls/intrinsics.cpp), in the form of library functions.

#include <span>

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

[[nodiscard]] std::span<const NativeFunction> language_words();

}  // namespace armlet::lang
