#pragma once
// Numbers by the rules of section 7: ints of 64 bits that never wrap round, doubles of IEEE 754.

#include <stdexcept>

#include "hir/hir_expr.hpp"
#include "value.hpp"

namespace armlet::oracle {

// What goes wrong in a calculation; who runs it knows where it stands in the text.
enum class Trouble { kOverflow, kDivisionByZero, kNegativeExponent, kFractionalPower, kNotFinite };
struct TroubleError : std::runtime_error {
  explicit TroubleError(Trouble what) : std::runtime_error("trouble"), trouble(what) {}
  Trouble trouble;
};

[[nodiscard]] Value calculate(lang::hir::Op op, const Value& a, const Value& b);
[[nodiscard]] Value negate(lang::hir::Op op, const Value& a);
// Toward zero.
[[nodiscard]] std::int64_t to_integer(double value);

}  // namespace armlet::oracle
