#include "check/state/constants.hpp"

#include <cmath>

#include "check/state/checker.hpp"

namespace armlet::lang {
namespace {

using hir::ExprKind;
using hir::Op;

constexpr int kDeepest = 100;

Constant integer(std::int64_t value) {
  return {.kind = Constant::Kind::kInt, .integer = value, .real = static_cast<double>(value)};
}
Constant real(double value) { return {.kind = Constant::Kind::kReal, .real = value}; }

std::optional<std::int64_t> whole_power(std::int64_t base, std::int64_t exponent) {
  std::int64_t out = 1;
  if (exponent < 0 || exponent > 64) return std::nullopt;
  for (; exponent > 0; --exponent) {
    if (__builtin_mul_overflow(out, base, &out)) return std::nullopt;
  }
  return out;
}

std::optional<Constant> compute(Op op, const Constant& a, const Constant& b) {
  std::int64_t whole = 0;
  const auto unless = [&](bool overflow) {
    return overflow ? std::nullopt : std::optional(integer(whole));
  };
  if (op == Op::kAddI) return unless(__builtin_add_overflow(a.integer, b.integer, &whole));
  if (op == Op::kSubI) return unless(__builtin_sub_overflow(a.integer, b.integer, &whole));
  if (op == Op::kMulI) return unless(__builtin_mul_overflow(a.integer, b.integer, &whole));
  if (op == Op::kDivI || op == Op::kModI) {
    if (b.integer == 0 || b.integer == -1) return std::nullopt;
    return integer(op == Op::kDivI ? a.integer / b.integer : a.integer % b.integer);
  }
  if (op == Op::kPowI) {
    const auto value = whole_power(a.integer, b.integer);
    return value ? std::optional(integer(*value)) : std::nullopt;
  }
  if (op == Op::kAddR) return real(a.real + b.real);
  if (op == Op::kSubR) return real(a.real - b.real);
  if (op == Op::kMulR) return real(a.real * b.real);
  if (op == Op::kDivR) return real(a.real / b.real);
  return std::nullopt;
}

bool is_number(const Constant& constant) {
  return constant.kind == Constant::Kind::kInt || constant.kind == Constant::Kind::kReal;
}

// The cost of a copy of the constant.
std::size_t size_of(const Constant& constant) {
  std::size_t size = 1 + constant.text.size();
  for (const Constant& item : constant.items) size += size_of(item);
  return size;
}

Constant to_real(Constant constant) {
  if (constant.kind == Constant::Kind::kInt) constant.kind = Constant::Kind::kReal;
  for (Constant& item : constant.items) item = to_real(std::move(item));
  return constant;
}

}  // namespace

std::optional<Constant> Constants::at(const hir::Expr& expr, int depth) const {
  if (depth > kDeepest) return std::nullopt;
  if (expr.kind == ExprKind::kBool) {
    return Constant{.kind = Constant::Kind::kBool, .truth = expr.as<hir::BoolExpr>().value};
  }
  if (expr.kind == ExprKind::kInt) {
    if (expr.type->is(Kind::kAny)) return std::nullopt;
    return integer(expr.as<hir::IntExpr>().value);
  }
  if (expr.kind == ExprKind::kReal) {
    return real(expr.as<hir::RealExpr>().value);
  }
  if (expr.kind == ExprKind::kText) {
    return Constant{.kind = Constant::Kind::kText,
                    .text = std::string(expr.as<hir::TextExpr>().value)};
  }
  if (expr.kind == ExprKind::kVariable) {
    const hir::Variable* variable = expr.as<hir::VariableExpr>().variable;
    while (variable->outer != nullptr) variable = variable->outer;
    const auto known = known_.find(variable);
    if (known != known_.end()) return known->second;
    return variable->init != nullptr ? at(*variable->init, depth + 1) : std::nullopt;
  }
  if (expr.kind == ExprKind::kConvert) {
    const auto& node = expr.as<hir::ConvertExpr>();
    if (node.conversion == hir::Conversion::kRealToInt || expr.type->is(Kind::kEnum))
      return std::nullopt;
    auto value = at(*node.operand, depth + 1);
    if (value && node.conversion != hir::Conversion::kSame) value = to_real(std::move(*value));
    return value;
  }
  if (expr.kind == ExprKind::kList) {
    Constant list{.kind = Constant::Kind::kList};
    for (const hir::Expr* item : expr.as<hir::ListExpr>().items) {
      auto value = at(*item, depth + 1);
      if (!value) return std::nullopt;
      list.items.push_back(std::move(*value));
    }
    return list;
  }
  if (expr.kind == ExprKind::kUnary) {
    const auto& node = expr.as<hir::UnaryExpr>();
    const auto value = at(*node.operand, depth + 1);
    if (!value) return std::nullopt;
    if (node.op == Op::kNegR) return real(-value->real);
    return node.op == Op::kNegI ? compute(Op::kSubI, integer(0), *value) : std::nullopt;
  }
  if (expr.kind == ExprKind::kBinary) {
    const auto& node = expr.as<hir::BinaryExpr>();
    const auto left = at(*node.left, depth + 1);
    const auto right = left && is_number(*left) ? at(*node.right, depth + 1) : std::nullopt;
    return right && is_number(*right) ? compute(node.op, *left, *right) : std::nullopt;
  }
  return std::nullopt;
}

void Constants::note(const hir::Variable& variable) {
  constexpr std::size_t kLargest = 1000;
  std::optional<Constant> value = of(*variable.init);
  if (value && size_of(*value) > kLargest) value.reset();
  known_.insert_or_assign(&variable, std::move(value));
}

const Fact* fact_of(const hir::Expr& expr) {
  const hir::Expr& origin = origin_of(expr);
  return origin.kind == ExprKind::kGuarded ? nullptr : origin.fact;
}

const hir::Expr& origin_of(const hir::Expr& expr) {
  const hir::Expr* at = &expr;
  for (int i = 0; i < kDeepest; ++i) {
    const hir::Expr* next = nullptr;
    if (at->kind == ExprKind::kVariable) next = at->as<hir::VariableExpr>().variable->init;
    if (at->kind == ExprKind::kConvert) next = at->as<hir::ConvertExpr>().operand;
    if (next == nullptr) break;
    at = next;
  }
  return *at;
}

hir::Expr* literal_of(Checker& checker, const Constant& constant, const Type* type, Span span) {
  switch (constant.kind) {
    case Constant::Kind::kBool:
      return checker.make<hir::BoolExpr>(ExprKind::kBool, checker.types.boolean(), span,
                                         constant.truth);
    case Constant::Kind::kText:
      return checker.make<hir::TextExpr>(ExprKind::kText, checker.types.text(), span,
                                         checker.arena.copy(constant.text));
    case Constant::Kind::kInt:
      if (type->is(Kind::kInt))
        return checker.make<hir::IntExpr>(ExprKind::kInt, type, span, constant.integer);
      return checker.make<hir::RealExpr>(ExprKind::kReal, type, span, constant.real);
    case Constant::Kind::kReal:
      return checker.make<hir::RealExpr>(ExprKind::kReal, type, span, constant.real);
    case Constant::Kind::kList:
      break;
  }
  return checker.failed(span);
}

// Arithmetic with two literals is done at compile time, so that -PI / 4 and 20 * 1mm are literals
// too.
hir::Expr* folded(Checker& checker, hir::BinaryExpr* expr) {
  const auto is_literal = [](const hir::Expr& side) {
    return side.kind == ExprKind::kInt || side.kind == ExprKind::kReal;
  };
  if (!is_literal(*expr->left) || !is_literal(*expr->right)) return expr;
  const auto value = checker.shared.constants.of(*expr);
  if (!value || !std::isfinite(value->real)) return expr;
  return literal_of(checker, *value, expr->type, expr->span);
}

}  // namespace armlet::lang
