#pragma once
// Calls that the checker itself understands (check/calls/intrinsics.cpp), described like functions
// of the library.

#include <span>

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

[[nodiscard]] std::span<const NativeFunction> language_words();

}  // namespace armlet::lang
