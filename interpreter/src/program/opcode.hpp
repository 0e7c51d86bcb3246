#pragma once
// The names of the instructions.

#include <cstddef>
#include <cstdint>

namespace armlet::lang {

enum class OpCode : std::uint16_t {
#define OP(name, ...) name,
#define VARIANT(name, ...) name,
#include "program/bytecode.def"
#undef VARIANT
#undef OP
  kCount
};

inline constexpr auto kOpCodes = static_cast<std::size_t>(OpCode::kCount);

}  // namespace armlet::lang
