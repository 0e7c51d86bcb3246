#include "check/expressions/operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "check/explain/edits.hpp"
#include "check/explain/mismatch_units.hpp"
#include "check/explain/nothings.hpp"
#include "check/explain/quotients.hpp"
#include "check/expressions/matrices.hpp"
#include "check/library/formatted.hpp"
#include "check/library/native_calls.hpp"
#include "check/library/overloads.hpp"
#include "check/state/checker.hpp"
#include "check/state/constants.hpp"
#include "check/types/mismatch.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

namespace {

hir::Expr* arithmetic(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                      hir::Expr* right);
hir::Expr* raise(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
const Type* power_of(Checker& checker, const Type* quantity, const hir::Expr& exponent, Span whole);
hir::Expr* raise_elements(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                          hir::Expr* right);
hir::Expr* compare(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                   hir::Expr* right);
hir::Expr* operator_native(Checker& checker, std::string_view op, Span op_span, Span span,
                           std::vector<hir::Expr*> operands);
hir::Expr* no_operator(Checker& checker, const ast::BinaryExpr& node, const hir::Expr& left,
                       const hir::Expr& right);
hir::Expr* different_dimensions(Checker& checker, const ast::BinaryExpr& node,
                                const hir::Expr& left, const hir::Expr& right);

using ast::BinaryOp;
using hir::Op;

struct OpPair {
  Op integer;
  Op real;
};

constexpr std::array<std::pair<BinaryOp, OpPair>, 6> kArithmetic = {
    {{BinaryOp::kAdd, {Op::kAddI, Op::kAddR}},
     {BinaryOp::kSub, {Op::kSubI, Op::kSubR}},
     {BinaryOp::kMul, {Op::kMulI, Op::kMulR}},
     {BinaryOp::kDiv, {Op::kDivI, Op::kDivR}},
     {BinaryOp::kMod, {Op::kModI, Op::kModR}},
     {BinaryOp::kPow, {Op::kPowI, Op::kPowR}}}};

struct Comparison {
  Op integer;
  Op real;
  Op text;
};

constexpr std::array<std::pair<BinaryOp, Comparison>, 6> kComparisons = {
    {{BinaryOp::kLess, {Op::kLtI, Op::kLtR, Op::kLtText}},
     {BinaryOp::kLessEq, {Op::kLeI, Op::kLeR, Op::kLeText}},
     {BinaryOp::kGreater, {Op::kGtI, Op::kGtR, Op::kGtText}},
     {BinaryOp::kGreaterEq, {Op::kGeI, Op::kGeR, Op::kGeText}},
     {BinaryOp::kEq, {Op::kEqI, Op::kEqR, Op::kEqText}},
     {BinaryOp::kNe, {Op::kNeI, Op::kNeR, Op::kNeText}}}};

// The row of a table for an operator; null if there is none.
const auto* row_of(const auto& table, BinaryOp op) {
  const auto found = std::ranges::find(table, op, [](const auto& row) { return row.first; });
  return found == table.end() ? nullptr : &found->second;
}

bool is_sum(BinaryOp op) {
  return op == BinaryOp::kAdd || op == BinaryOp::kSub || op == BinaryOp::kMod;
}
bool is_equality(BinaryOp op) { return op == BinaryOp::kEq || op == BinaryOp::kNe; }
bool is_int_literal(const hir::Expr& expr) { return expr.kind == hir::ExprKind::kInt; }

}  // namespace

hir::Expr* check_unary(Checker& checker, const ast::UnaryExpr& unary, const Type* expected) {
  if (unary.op == ast::UnaryOp::kMinus && unary.operand->kind == ast::ExprKind::kInt &&
      unary.operand->as<ast::IntExpr>().too_large &&
      checker.text_of(unary.operand->span) == "9223372036854775808") {
    return checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(), unary.span,
                                      std::numeric_limits<std::int64_t>::min());
  }
  hir::Expr* value = checker.check_value(*unary.operand, expected);
  const Type* type = value->type;
  if (type->is(Kind::kAny)) return checker.failed(unary.span);
  if (unary.op == ast::UnaryOp::kNot && type->is(Kind::kBool)) {
    return checker.make<hir::UnaryExpr>(hir::ExprKind::kUnary, type, unary.span, Op::kNot, value);
  }
  if (unary.op == ast::UnaryOp::kPlus && type->is_number()) return value;
  if (unary.op == ast::UnaryOp::kMinus) {
    constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
    if (value->kind == hir::ExprKind::kInt && value->as<hir::IntExpr>().value != kLeast) {
      return checker.make<hir::IntExpr>(hir::ExprKind::kInt, type, unary.span,
                                        -value->as<hir::IntExpr>().value);
    }
    if (value->kind == hir::ExprKind::kReal) {
      return checker.make<hir::RealExpr>(hir::ExprKind::kReal, type, unary.span,
                                         -value->as<hir::RealExpr>().value);
    }
    if (type->is_number()) {
      const Op op = type->is(Kind::kInt) ? Op::kNegI : Op::kNegR;
      return checker.make<hir::UnaryExpr>(hir::ExprKind::kUnary, type, unary.span, op, value);
    }
    const Span mark{unary.span.begin, unary.span.begin + 1, unary.span.source};
    if (hir::Expr* result = operator_native(checker, "-", mark, unary.span, {value})) return result;
  }
  const std::string_view op = unary.op == ast::UnaryOp::kNot    ? "!"
                              : unary.op == ast::UnaryOp::kPlus ? "+"
                                                                : "-";
  checker.report(make_diagnostic("E0317", unary.span, {std::string(op), type_phrase(type)}));
  return checker.failed(unary.span);
}

// Chains such as a + b + c ... are trees that grow to the left and may have thousands of levels, so
// they are checked by a loop. Joined texts become one node.
hir::Expr* check_binary(Checker& checker, const ast::BinaryExpr& binary, const Type* expected) {
  std::vector<const ast::BinaryExpr*> chain = {&binary};
  while (chain.back()->left->kind == ast::ExprKind::kBinary) {
    chain.push_back(&chain.back()->left->as<ast::BinaryExpr>());
  }
  // The operands of a sum have the type of the sum; those of a product may have other types.
  const bool is_alone = chain.size() == 1 && is_sum(binary.op);
  const ast::Expr* nothing = nothing_in(checker, *chain.back());
  auto node = chain.rbegin();
  hir::Expr* left = nullptr;
  if (nothing != nullptr && nothing == chain.back()->left) {
    left = compared_with_nothing(checker, **node, *nothing, *checker.check_value(*(*node)->right));
    ++node;
  } else {
    left = checker.check_value(*chain.back()->left, is_alone ? expected : nullptr);
  }
  std::vector<hir::Expr*> texts;
  for (; node != chain.rend(); ++node) {
    const ast::BinaryExpr& at = **node;
    nothing = nothing_in(checker, at);
    if (nothing != nullptr && nothing == at.right) {
      left = compared_with_nothing(checker, at, *nothing, *left);
      texts.clear();
      continue;
    }
    hir::Expr* right = checker.check_value(*at.right);
    if (at.op == BinaryOp::kAdd && !left->type->is(Kind::kAny) && !right->type->is(Kind::kAny) &&
        (left->type->is(Kind::kText) || right->type->is(Kind::kText))) {
      if (texts.empty()) texts.push_back(to_text(checker, left));
      texts.push_back(to_text(checker, right));
      const auto next = std::next(node);
      if (next != chain.rend() && (*next)->op == BinaryOp::kAdd) {
        left = texts.back();
        continue;
      }
      left = checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types.text(), at.span,
                                           checker.seq(texts));
      texts.clear();
      continue;
    }
    if (!texts.empty()) {
      left = checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types.text(),
                                           at.left->span, checker.seq(texts));
      texts.clear();
    }
    left = combine(checker, at, left, right);
  }
  return left;
}

namespace {

// The likely type of an operation with one unknown operand: for a sum that of the other operand.
// Null: any.
const Type* likely_type(const Checker& checker, BinaryOp op, const hir::Expr& left,
                        const hir::Expr& right) {
  if (row_of(kComparisons, op)) return checker.types.boolean();
  const hir::Expr& known = left.type->is(Kind::kAny) ? right : left;
  return is_sum(op) && !known.type->is(Kind::kAny) ? known.type : nullptr;
}

}  // namespace

hir::Expr* combine(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                   hir::Expr* right) {
  if (node.op == BinaryOp::kAnd || node.op == BinaryOp::kOr) {
    for (const hir::Expr* side : {left, right}) {
      if (side->type->is(Kind::kBool) || side->type->is(Kind::kAny)) continue;
      checker.report(make_diagnostic("E0309", side->span, {type_phrase(side->type)}));
      return checker.failed(node.span);
    }
    const auto kind = node.op == BinaryOp::kAnd ? hir::ExprKind::kAnd : hir::ExprKind::kOr;
    return checker.make<hir::BinaryExpr>(kind, checker.types.boolean(), node.span, Op::kEqI, left,
                                         right, node.op_span);
  }
  if (left->type->is(Kind::kAny) || right->type->is(Kind::kAny))
    return checker.guessed(node.span, likely_type(checker, node.op, *left, *right));
  if (row_of(kComparisons, node.op)) return compare(checker, node, left, right);
  if (left->type->is_number() && right->type->is_number()) {
    if (node.op == BinaryOp::kPow) return raise(checker, node, left, right);
    if (row_of(kArithmetic, node.op)) return arithmetic(checker, node, left, right);
  }
  const bool quantities = left->type->is(Kind::kList) && left->type->element->is_quantity();
  if (node.op == BinaryOp::kElemPow && quantities && right->type->is_number())
    return raise_elements(checker, node, left, right);
  hir::Expr* result =
      operator_native(checker, operator_text(node.op), node.op_span, node.span, {left, right});
  return result != nullptr ? result : no_operator(checker, node, *left, *right);
}

namespace {

hir::Expr* arithmetic(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                      hir::Expr* right) {
  const OpPair ops = *row_of(kArithmetic, node.op);
  const auto binary = [&](const Type* type, Op op, hir::Expr* a, hir::Expr* b) {
    return folded(checker, checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, type, node.span,
                                                         op, a, b, node.op_span));
  };
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt)) {
    hir::Expr* result = binary(checker.types.integer(), ops.integer, left, right);
    if (node.op == BinaryOp::kDiv && is_int_literal(*left) && is_int_literal(*right)) {
      const std::int64_t by = right->as<hir::IntExpr>().value;
      if (by != 0 && by != -1 && left->as<hir::IntExpr>().value % by != 0)
        advise_whole_quotient(checker, node.span, left->span, right->span,
                              std::to_string(left->as<hir::IntExpr>().value / by));
    }
    return result;
  }
  if (is_sum(node.op)) {
    const Type* type = common_type(checker, *left, *right);
    if (type == nullptr) return different_dimensions(checker, node, *left, *right);
    return binary(type, ops.real, checker.convert(left, type), checker.convert(right, type));
  }
  const auto dim = node.op == BinaryOp::kMul ? multiply(left->type->dim, right->type->dim)
                                             : divide(left->type->dim, right->type->dim);
  if (!dim) {
    checker.report(make_diagnostic("E0409", node.span));
    return checker.failed(node.span);
  }
  // The int (i / columns) in (i / columns) * pitch is intended.
  const auto as_real = [&](hir::Expr* side, const hir::Expr& other) {
    if (!side->type->is(Kind::kInt)) return side;
    const bool counts = other.type->is_quantity() && side->kind == hir::ExprKind::kBinary;
    return counts ? cast(checker, side, checker.types.real(), side->span)
                  : checker.convert(side, checker.types.real());
  };
  hir::Expr* const a = as_real(left, *right);
  return binary(checker.types.quantity(*dim), ops.real, a, as_real(right, *left));
}

hir::Expr* raise(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  const auto binary = [&](const Type* type, Op op, hir::Expr* a, hir::Expr* b) {
    return checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, type, node.span, op, a, b,
                                         node.op_span);
  };
  const bool negative = is_int_literal(*right) && right->as<hir::IntExpr>().value < 0;
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt) && !negative) {
    hir::BinaryExpr* result = binary(checker.types.integer(), Op::kPowI, left, right);
    if (checker.surroundings.is_classic() && is_int_literal(*left) && is_int_literal(*right)) {
      std::string shown = checker.text_of(node.span);
      if (const auto value = checker.shared.constants.of(*result))
        shown += " is " + std::to_string(value->integer);
      Diagnostic advice = make_diagnostic("W0703", node.op_span, {shown});
      advice.why = "in Java `^` mixes bits";
      advice.fix = Fix{.text = "ignore this if a power was meant"};
      checker.report(std::move(advice));
    }
    return result;
  }
  hir::Expr* exponent = checker.convert(right, checker.types.real());
  if (exponent == nullptr)
    return mismatch(checker, *right, {.type = checker.types.real(), .name = "exponent"});
  if (!left->type->is_quantity()) {
    return binary(checker.types.real(), Op::kPowR, checker.convert(left, checker.types.real()),
                  exponent);
  }
  const Type* type = power_of(checker, left->type, *exponent, node.span);
  return type == nullptr ? checker.failed(node.span) : binary(type, Op::kPowR, left, exponent);
}

// The type of a quantity with a constant exponent; null after a message.
const Type* power_of(Checker& checker, const Type* quantity, const hir::Expr& exponent,
                     Span whole) {
  const auto constant = checker.shared.constants.of(exponent);
  const double halves = constant ? constant->real * 2.0 : 0.5;
  if (halves != std::round(halves) || std::abs(halves) > 1000.0) {
    checker.report(make_diagnostic("E0408", exponent.span));
    return nullptr;
  }
  const auto dim = power(quantity->dim, static_cast<int>(halves));
  if (!dim) {
    checker.report(make_diagnostic("E0409", whole));
    return nullptr;
  }
  return checker.types.quantity(*dim);
}

// lengths .^ 2: computed on plain numbers, because no signature can express the effect of the
// exponent on the unit.
hir::Expr* raise_elements(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                          hir::Expr* right) {
  const Type* element = power_of(checker, left->type->element, *right, node.span);
  if (element == nullptr) return checker.failed(node.span);
  const auto as = [&](const Type* type, hir::Expr* value) {
    return checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span,
                                          hir::Conversion::kSame, value);
  };
  hir::Expr* result = operator_native(checker, ".^", node.op_span, node.span,
                                      {as(checker.types.list(checker.types.real()), left), right});
  if (result == nullptr) return no_operator(checker, node, *left, *right);
  return as(checker.types.list(element), result);
}

hir::Expr* compare(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                   hir::Expr* right) {
  const Comparison ops = *row_of(kComparisons, node.op);
  const auto binary = [&](Op op, hir::Expr* a, hir::Expr* b) {
    return checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, checker.types.boolean(), node.span,
                                         op, a, b, node.op_span);
  };
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt))
    return binary(ops.integer, left, right);
  if (left->type->is_number() && right->type->is_number()) {
    const Type* type = common_type(checker, *left, *right);
    if (type == nullptr) return different_dimensions(checker, node, *left, *right);
    return binary(ops.real, checker.convert(left, type), checker.convert(right, type));
  }
  if (left->type->is(Kind::kText) && right->type->is(Kind::kText))
    return binary(ops.text, left, right);
  if (!is_equality(node.op)) return no_operator(checker, node, *left, *right);
  const bool by_number = left->type->is(Kind::kBool) || left->type->is(Kind::kEnum);
  if (by_number && left->type == right->type) return binary(ops.integer, left, right);
  const Type* type = common_type(checker, *left, *right);
  if (type == nullptr || by_number || !has_deep_equality(type))
    return no_operator(checker, node, *left, *right);
  return binary(node.op == BinaryOp::kEq ? Op::kEqDeep : Op::kNeDeep, checker.convert(left, type),
                checker.convert(right, type));
}

// A call of the operator that the library declares for these types; null if there is none.
hir::Expr* operator_native(Checker& checker, std::string_view op, Span op_span, Span span,
                           std::vector<hir::Expr*> operands) {
  const std::string name = "operator" + std::string(op);
  std::vector<Argument> arguments;
  for (hir::Expr* operand : operands) arguments.push_back({.value = operand});
  std::vector<const NativeFunction*> fitting;
  for (const NativeFunction* candidate : checker.registry.functions(name)) {
    if (fit(checker, checker.shared.signatures.of(*candidate), arguments, false).problem ==
        Fit::Problem::kNone)
      fitting.push_back(candidate);
  }
  if (fitting.empty()) return nullptr;
  return call_native(checker, name, fitting, op_span, span, std::move(arguments));
}

}  // namespace

// Whether the library declares an operator for these types.
static bool has_operator(Checker& checker, std::string_view name, const hir::Expr& left,
                         const hir::Expr& right) {
  return std::ranges::any_of(
      checker.registry.functions(name), [&](const NativeFunction* candidate) {
        const auto& parameters = checker.shared.signatures.of(*candidate).parameters;
        Bindings bindings;
        return parameters.size() == 2 &&
               match(parameters[0].type, left.type, false, bindings) >= 0 &&
               match(parameters[1].type, right.type, false, bindings) >= 0;
      });
}

namespace {

hir::Expr* no_operator(Checker& checker, const ast::BinaryExpr& node, const hir::Expr& left,
                       const hir::Expr& right) {
  const std::string op(operator_text(node.op));
  if (!checker.messages.takes_errors()) {
    checker.report(make_diagnostic("E0316", node.op_span, {"", "", ""}));
    return checker.failed(node.span);
  }
  if (left.type->is(Kind::kList) && right.type->is(Kind::kList) &&
      (node.op == BinaryOp::kMul || node.op == BinaryOp::kDiv)) {
    Diagnostic diagnostic = make_diagnostic("E0304", node.span, {op});
    diagnostic.mark.label = left.type == right.type
                                ? "both are " + type_name(left.type)
                                : type_name(left.type) + " and " + type_name(right.type);
    const std::string a = checker.text_of(left.span);
    const std::string b = checker.text_of(right.span);
    const std::string each = as_operand(a) + " ." + op + ' ' + as_operand(b);
    const std::string element_wise = each + " for element by element";
    diagnostic.fix = node.op == BinaryOp::kMul
                         ? Fix{.text = "write dot(" + a + ", " + b + ") for the inner product or " +
                                       element_wise,
                               .edits = {{node.span, "dot(" + a + ", " + b + ")"}}}
                         : Fix{.text = "write " + element_wise, .edits = {{node.span, each}}};
    checker.report(std::move(diagnostic));
    return checker.failed(node.span);
  }
  const hir::Expr* text = left.type->is(Kind::kText)    ? &left
                          : right.type->is(Kind::kText) ? &right
                                                        : nullptr;
  if (text != nullptr && row_of(kArithmetic, node.op)) {
    checker.report(make_diagnostic("E0314", text->span, {"a text"}));
    return checker.failed(node.span);
  }
  Diagnostic diagnostic =
      make_diagnostic("E0316", node.op_span, {op, type_phrase(left.type), type_phrase(right.type)});
  diagnostic.related.push_back({left.span, type_name(left.type)});
  diagnostic.related.push_back({right.span, type_name(right.type)});
  diagnostic.fix = matrix_operator_fix(checker, node, left, right);
  // Of two poses; a product with a number is a multiple.
  const auto is_placed = [](const Type* type) {
    return !type->is_number() && !type->is(Kind::kMatrix);
  };
  if (!diagnostic.fix && node.op == BinaryOp::kAdd && is_placed(left.type) &&
      is_placed(right.type) && has_operator(checker, "operator*", left, right)) {
    const std::string product =
        as_operand(checker.text_of(left.span)) + " * " + as_operand(checker.text_of(right.span));
    diagnostic.fix = Fix{.text = "to put one behind the other, write " + product,
                         .edits = {{node.span, product}}};
  }
  checker.report(std::move(diagnostic));
  return checker.failed(node.span);
}

hir::Expr* different_dimensions(Checker& checker, const ast::BinaryExpr& node,
                                const hir::Expr& left, const hir::Expr& right) {
  if (!left.type->is_quantity() || !right.type->is_quantity()) {
    const bool left_plain = !left.type->is_quantity();
    plain_number_for_quantity(checker, left_plain ? left : right,
                              {.type = left_plain ? right.type : left.type});
    return checker.failed(node.span);
  }
  const std::string a = dimension_phrase(left.type->dim);
  const std::string b = dimension_phrase(right.type->dim);
  const bool minus = node.op == BinaryOp::kSub;
  std::string done = "compared with";
  if (node.op == BinaryOp::kAdd) done = "added to";
  if (minus) done = "subtracted from";
  if (node.op == BinaryOp::kMod) done = "divided with a remainder by";
  Diagnostic diagnostic =
      make_diagnostic("E0402", right.span, {minus ? b : a, done, minus ? a : b});
  diagnostic.mark.label = dimension_name(right.type->dim);
  diagnostic.related.push_back({left.span, dimension_name(left.type->dim)});
  diagnostic.fix = Fix{.text = "check which of the two was meant"};
  checker.report(std::move(diagnostic));
  return checker.failed(node.span);
}

}  // namespace

}  // namespace armlet::lang
