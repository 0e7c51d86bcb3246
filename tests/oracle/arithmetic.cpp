#include "arithmetic.hpp"

#include <cmath>
#include <limits>

#include "armlet/math/det_math.hpp"

namespace armlet::oracle {

using lang::hir::Op;

namespace {

__extension__ using Wide = __int128;

std::int64_t narrow(Wide value) {
  if (value < std::numeric_limits<std::int64_t>::min() ||
      value > std::numeric_limits<std::int64_t>::max()) {
    throw TroubleError(Trouble::kOverflow);
  }
  return static_cast<std::int64_t>(value);
}

std::int64_t power(std::int64_t base, std::int64_t exponent) {
  if (exponent < 0) throw TroubleError(Trouble::kNegativeExponent);
  if (base == 0 || base == 1) return exponent == 0 ? 1 : base;
  if (base == -1) return exponent % 2 == 0 ? 1 : -1;
  std::int64_t out = 1;
  for (; exponent > 0; --exponent) out = narrow(Wide{out} * base);
  return out;
}

std::int64_t whole(Op op, std::int64_t a, std::int64_t b) {
  switch (op) {
    case Op::kAddI:
      return narrow(Wide{a} + b);
    case Op::kSubI:
      return narrow(Wide{a} - b);
    case Op::kMulI:
      return narrow(Wide{a} * b);
    case Op::kDivI:
      if (b == 0) throw TroubleError(Trouble::kDivisionByZero);
      return narrow(Wide{a} / b);
    case Op::kModI:
      if (b == 0) throw TroubleError(Trouble::kDivisionByZero);
      return narrow(Wide{a} % b);
    default:
      return power(a, b);
  }
}

double real_power(double a, double b) {
  const double out = det::pow(a, b);
  if (std::isnan(out) && !std::isnan(a) && !std::isnan(b))
    throw TroubleError(Trouble::kFractionalPower);
  return out;
}

double real(Op op, double a, double b) {
  switch (op) {
    case Op::kAddR:
      return a + b;
    case Op::kSubR:
      return a - b;
    case Op::kMulR:
      return a * b;
    case Op::kDivR:
      return a / b;
    case Op::kModR:
      return std::fmod(a, b);
    default:
      return real_power(a, b);
  }
}

template <class T>
bool compare(int order, const T& a, const T& b) {
  switch (order) {
    case 0:
      return a < b;
    case 1:
      return a <= b;
    case 2:
      return a > b;
    case 3:
      return a >= b;
    case 4:
      return a == b;
    default:
      return a != b;
  }
}

int order_text(Op op) {
  switch (op) {
    case Op::kLtText:
      return 0;
    case Op::kLeText:
      return 1;
    case Op::kGtText:
      return 2;
    case Op::kGeText:
      return 3;
    case Op::kEqText:
      return 4;
    default:
      return 5;
  }
}

bool is_between(Op op, Op first, Op last) { return op >= first && op <= last; }

}  // namespace

Value calculate(Op op, const Value& a, const Value& b) {
  if (is_between(op, Op::kAddI, Op::kPowI)) return {whole(op, a.integer(), b.integer())};
  if (is_between(op, Op::kAddR, Op::kPowR)) return {real(op, a.real(), b.real())};
  if (op == Op::kEqI || op == Op::kEqDeep) return {equal(a, b)};  // also bool and enum
  if (op == Op::kNeI || op == Op::kNeDeep) return {!equal(a, b)};
  if (is_between(op, Op::kLtI, Op::kGeI)) {
    return {compare(static_cast<int>(op) - static_cast<int>(Op::kLtI), a.integer(), b.integer())};
  }
  if (is_between(op, Op::kLtR, Op::kNeR)) {
    return {compare(static_cast<int>(op) - static_cast<int>(Op::kLtR), a.real(), b.real())};
  }
  return {compare(order_text(op), a.text(), b.text())};
}

Value negate(Op op, const Value& a) {
  if (op == Op::kNot) return {!a.truth()};
  if (op == Op::kNegI) return {narrow(-Wide{a.integer()})};
  return {-a.real()};
}

std::int64_t to_integer(double value) {
  if (!std::isfinite(value)) throw TroubleError(Trouble::kNotFinite);
  const double cut = std::trunc(value);
  if (cut < -9223372036854775808.0 || cut >= 9223372036854775808.0)
    throw TroubleError(Trouble::kOverflow);
  return static_cast<std::int64_t>(cut);
}

}  // namespace armlet::oracle
